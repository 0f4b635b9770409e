# SPDX-License-Identifier: Apache-2.0
"""What checks pages, headers and releases can fail, and names the place. Each test gets a copy of the files that it spoils."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def says(code, words, *command, cwd=ROOT):
    """The command ends with this exit code, or any but 0 for None, and says each of the words, which lines separate."""
    done = subprocess.run([str(word) for word in command], cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == code or (code is None and done.returncode), (command, done.returncode, done.stdout)
    for line in words.splitlines():
        assert line in done.stdout


def copy(folder, *patterns):
    for path in (path for pattern in patterns for path in ROOT.glob(pattern)):
        target = folder / path.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if path.is_dir() else shutil.copy)(path, target)


def test_api_docs(tmp_path):
    """An undocumented member, in any folder of public headers."""
    copy(tmp_path, "docs/Doxyfile", "docs/make/site/api_docs.sh", "lib*/**/include", "verification/closed_form/include")
    folders = [path for path in tmp_path.glob("*/**/include/*") if path.is_dir()]
    for folder in folders:
        (folder / "bare.hpp").write_text(f"// the first line names the file\nnamespace bare {{\nstruct Bare_{folder.name} {{ double bare; }};\n}}\n")
    said = [f"of struct bare::Bare_{folder.name} is not documented" for folder in folders]
    says(None, "\n".join(said), tmp_path / "docs/make/site/api_docs.sh", tmp_path / "out")


def test_case_reference(tmp_path):
    """A wrong unit, range, default and link, a row without a key and a key without a row."""
    page = (ROOT / "docs/case_files.md").read_text()
    for before, after in [("at the start | rad/s", "at the start | rad"), ("| 293.15 |", "| 300 |"), ("| `pivot`", "| `colour`"),
                          ("theory/membrane.md#laws", "theory/membrane.md#meshes"), ("of the outlet | m | above 0", "of the outlet | m | 0 or more")]:
        assert before in page
        page = page.replace(before, after)
    (tmp_path / "page.md").write_text(page)
    words = "rad/s |\n| 293.15 |\nno case asks for pendulum.colour\nno row for the key pendulum.pivot\nthe program says\n| above 0 |"
    says(1, words, sys.executable, "-B", ROOT / "docs/make/pages/case_keys.py", "--check", os.environ["GASJET"], tmp_path / "page.md")


@pytest.mark.parametrize("words, line", [
    ("KaTeX parse error", r'<span class="arithmatex">\(\fraction{1}{2}\)</span>'),
    ("no equation found", "text"),
    ("equation left as source", r'<span class="arithmatex">\(\rho &lt; \frac{1}{2}\)</span>'),
    ("gone.csv: no such file", '<a href="gone.csv">table</a>'),
    ("#gone: no such anchor", '<a href="#gone">part</a>'),
    ("https://example.org/a.js: loaded from elsewhere", '<script src="https://example.org/a.js"></script>'),
])
def test_site(words, line, tmp_path):
    (tmp_path / "index.html").write_text(f"<h1 id='top'>Page</h1>\n<a href='#top'>up</a> {line}\n")
    render = ("env", "NODE_PATH=/usr/share/nodejs", "node", ROOT / "docs/make/site/render_equations.js", tmp_path)
    check = (sys.executable, "-B", ROOT / "docs/make/site/check_links.py", tmp_path)
    says(None, words, *(render if "equation found" in words or "KaTeX" in words else check))
    if "source" in words:
        says(0, "", *render)
        says(0, "", *check)


TANK = """#pragma once
namespace gas {
enum class Kind { round_one, other };
class Tank {
 public:
  int size() const { return size_; }

 private:
  int size_ = 0;
};
}
"""


@pytest.mark.parametrize("words, before, after", [
    ("'tank' [readability-identifier-naming", "class Tank", "class tank"),
    ("'roundOne' [readability-identifier-naming", "round_one", "roundOne"),
    ("unknown type name 'real'", "int size_ =", "real size_ ="),
    ("libgas/src/tank.cpp:2:", "", ""),  # a source
])
def test_tidy(words, before, after, tmp_path):
    copy(tmp_path, ".clang-tidy")
    for folder in ("libgas/include", "libgas/src", "libjet/src", "libjet/include", "driver/include", "driver/src"):
        (tmp_path / folder).mkdir(parents=True)
    header, tidy = tmp_path / "libgas/include/tank.hpp", ROOT / "verification/rules/tidy.sh"
    header.write_text(TANK)
    (tmp_path / "libjet/src/jet.hpp").write_text('#pragma once\n#include "tank.hpp"\n')
    says(0, "", tidy, tmp_path, tmp_path)
    header.write_text(TANK.replace(before, after))
    if before:
        return says(1, words, tidy, tmp_path, tmp_path)
    (tmp_path / "build.ninja").write_text(f"rule cxx\n  command = c++ -c $in -o $out\nbuild tank.o: cxx {tmp_path}/libgas/src/tank.cpp\n")
    (tmp_path / "libgas/src/tank.cpp").write_text("namespace {\nint sizeOf() { return 1; }\n}\nint main() { return sizeOf(); }\n")
    says(1, words, tidy, tmp_path, tmp_path, "sources")


def git(tree, *arguments):
    return subprocess.run(["git", "-c", "safe.directory=*", "-c", "user.name=test", "-c", "user.email=test@example.org", "-C", tree, *arguments],
                          check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def clone(tmp_path):
    """The work tree as it is, as one commit with a closed changelog and tests that are red."""
    try:
        names = git(ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard")
    except subprocess.CalledProcessError:
        pytest.skip("the sources are no clone")
    tree = tmp_path / "clone"
    tree.mkdir()
    subprocess.run(["tar", "-C", ROOT, "--null", "--ignore-failed-read", "-T", "-", "-cf", tmp_path / "all.tar"], input=names, text=True, check=True)
    subprocess.run(["tar", "-C", tree, "-xf", tmp_path / "all.tar"], check=True)
    changelog = (tree / "CHANGELOG.md").read_text()
    (tree / "CHANGELOG.md").write_text(changelog[changelog.index("\n## 0") + 1:] if "## Unreleased" in changelog else changelog)
    (tree / "scripts/test_all.sh").write_text("#!/bin/bash\nexit 1\n")
    git(tree, "init", "-q")
    git(tree, "add", "-A")
    git(tree, "commit", "-q", "-m", "All")
    return tree


def test_release(clone):
    """A tree that is not fit for a release is refused."""
    def check(code, words):
        says(code, words, "env", "GIT_CONFIG_COUNT=0", clone / "scripts/release.sh", "--check", cwd=clone)

    check(2, "the tests are red")
    (clone / "build").mkdir()
    (clone / "build/green").write_text(f"{git(clone, 'rev-parse', 'HEAD')} fast long sanitize\n")
    check(0, "is fit for a release")
    (clone / "forgotten").touch()
    check(2, "?? forgotten")
    with open(clone / "CHANGELOG.md", "a", encoding="utf-8") as file:
        print("## Unreleased", file=file)
    git(clone, "add", "-A")
    git(clone, "commit", "-q", "-m", "Open the changelog")
    check(2, "CHANGELOG.md: 'Unreleased'")


def test_commit_of_a_tree(clone, tmp_path):
    """A source archive names its commit, and so does a clone, but no folder of another repository."""
    def commit_of(folder):
        (tmp_path / "template").write_text("@GASJET_COMMIT@\n")
        subprocess.run(["cmake", f"-DSOURCE_DIR={folder}", f"-DTEMPLATE={tmp_path}/template", f"-DOUTPUT={tmp_path}/output", "-P",
                        f"{folder}/cmake/BuildInfo.cmake"], check=True)
        return (tmp_path / "output").read_text().strip()

    head = git(clone, "rev-parse", "--short=12", "HEAD")
    git(clone, "tag", "--annotate", "v9.9.9", "--message", "release")
    assert commit_of(clone) == head
    git(clone, "archive", "-o", tmp_path / "archive.tar", "HEAD")
    (tmp_path / "archive").mkdir()
    subprocess.run(["tar", "-C", tmp_path / "archive", "-xf", tmp_path / "archive.tar"], check=True)
    assert commit_of(tmp_path / "archive") == head
    shutil.copytree(clone / "cmake", clone / "inner/cmake")
    assert commit_of(clone / "inner") == "unknown"
    (clone / "README.md").write_text("changed")
    assert commit_of(clone) == f"{head}-dirty"
