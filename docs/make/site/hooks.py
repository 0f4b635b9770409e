# SPDX-License-Identifier: Apache-2.0
# Hook of mkdocs.yml: the site reads lists as GitHub does, where Python-Markdown differs, its menu leads to every page, and README's
# picture to the report that only the site has; cases run where they are named.
import logging
import pathlib
import re

from markdown.blockprocessors import build_block_parser
from markdown.extensions import Extension
from markdown.preprocessors import Preprocessor

CASES = pathlib.Path(__file__).resolve().parents[3] / "cases"


class GithubLists(Extension):
    """Two spaces nest a list, not four; no blank line is needed before one."""

    def extendMarkdown(self, md):
        md.tab_length = 2
        md.parser = build_block_parser(md)
        md.preprocessors.register(BlankLineBeforeList(md), "blank_line_before_list", 10)


class BlankLineBeforeList(Preprocessor):
    """Runs after fenced code is taken out of the text."""

    def run(self, lines):
        result = []
        for line in lines:
            if re.match(r"[-*] |1\. ", line) and result and re.match(r"[^\s\-*\d]", result[-1]):
                result.append("")
            result.append(line)
        return result


def on_config(config):
    config["markdown_extensions"].insert(0, GithubLists())
    return config


def on_page_markdown(markdown, page, config, files):
    picture = "docs/figures/passenger_pendulum.svg)\n"
    if page.file.src_path != "README.md":
        return markdown
    assert picture in markdown, "README.md has lost its picture"
    return markdown.replace(picture, picture + "\n[Both runs in motion](reports/passenger_pendulum.html)\n", 1)


def run_here(name, base):
    """A place that fills with the page that runs cases, when it is opened."""
    return (f'<details class="run" ontoggle="this.querySelector(\'iframe\').src ||= \'{base}try.html#run={name}\'">'
            f"<summary>Run {name} here</summary><iframe title=\"{name}\" allow=\"clipboard-write\"></iframe></details>")


def live(html, page, config, base):
    """Figures that readers move (bindings/browser/page/live.js): each closed form of the catalogue has one below its name. None if the site is made without them."""
    if not (pathlib.Path(config["docs_dir"]) / "assets" / "live.js").exists():
        return html
    if page.file.src_path == "docs/exact.md":
        html = re.sub(r"<p><strong><code>(\w+)</code></strong>.*?</p>", lambda form: (
            f'{form[0]}<details class="run"><summary>Run {form[1]} here</summary><div class="gasjet-live" data-form="{form[1]}"></div></details>'),
            html, flags=re.S)
    return f'{html}<script src="{base}assets/live.js"></script>' if 'class="gasjet-live"' in html else html


def on_page_content(html, page, config, files):
    """Below a heading or a block of commands that names shipped cases, each of them once a page."""
    base, seen = "../" * page.file.dest_path.count("/"), set()
    html = live(html, page, config, base)

    def place(found):
        names = [name for name in re.findall(r"cases/([a-z_]+)\.toml", found[0]) if (CASES / f"{name}.toml").exists() and name not in seen]
        names = list(dict.fromkeys(names))
        seen.update(names)
        return found[0] + "".join(run_here(name, base) for name in names)

    return re.sub(r'<h2.*?</h2>|<div class="highlight">.*?</div>', place, html, flags=re.S)


def on_nav(nav, config, files):
    known = {page.file.src_path for page in nav.pages}
    for file in files.documentation_pages():
        if file.src_path not in known:
            logging.getLogger("mkdocs.menu").warning("%s is not in the nav of mkdocs.yml", file.src_path)
    return nav
