namespace cd {}
