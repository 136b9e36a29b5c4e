// Proves that a shell reads each quoted word as it was.
#include "client/base/shell_word.hpp"

#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

TEST(ShellWord, PlainWordsStayAsTheyAre) {
    for (const char* const word :
         {"out", "/tmp/out-1.2", "--master", "node-1:7600", "a=b,c_d@e%"}) {
        EXPECT_EQ(shell_word(word), word);
    }
    EXPECT_EQ(shell_word("my results"), "'my results'");
}

TEST(ShellWord, AShellReadsEachWordAsItWas) {
    const std::vector<std::string> words{"",
                                         "my results",
                                         "it's",
                                         "''",
                                         "$HOME",
                                         "`id`",
                                         "a\\b",
                                         "~",
                                         "*",
                                         "#x",
                                         "a;b&c|d",
                                         "\"",
                                         "!1"};
    for (const std::string& word : words) {
        const Ran ran = run({"/bin/sh", "-c", "printf '[%s]' " + shell_word(word)});
        EXPECT_EQ(ran.output, "[" + word + "]");
    }
}

} // namespace cd::tests
