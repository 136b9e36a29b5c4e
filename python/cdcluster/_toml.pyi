from collections.abc import Mapping
from typing import Any

def toml_text(job: Mapping[str, Any]) -> str: ...
