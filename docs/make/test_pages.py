# SPDX-License-Identifier: Apache-2.0
"""What writes the pages says what its files say, and each check can fail."""
import pathlib
import re
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "pages"), str(HERE / "site")]
import api_pages  # noqa: E402
import claims  # noqa: E402
import gallery  # noqa: E402
import write  # noqa: E402

HEAD = "# machine: M, 2 cores\n# gasjet 0.1.0 (0123abc, GNU 12, Release -O3)\n"


@pytest.fixture
def tree(tmp_path, monkeypatch):
    """A repository of one page with a table and a sentence, of two tables and a page."""
    files = {
        "README.md": "All:\n\n<!-- table forces -->\n\nold\n\n<!-- end of table forces -->\n\nEnd.\n",
        "docs/page.md": "<!-- text sentence -->\n\nold\n\n<!-- end of text sentence -->\n",
        "docs/charts/ladder.csv": HEAD + "# counted from: 3\n# reference: 1\nrung,runs,error\nfull,16,0.05\n",
        "docs/charts/force.csv": HEAD + 'case,force_kN,options\none,0.01234,"a, b"\ntwo,5,\n',
        "docs/report.md": "| check | off |\n|---|---|\n| one \\| other | 0.03 m |\n",
        "docs/make/pages/tables/forces.j2": '% set table = csv("docs/charts/force.csv")\n| case | force [N] |\n|---|---|\n'
        '% for case in ["one", "two"]\n| {{ case }} | {{ f(table.row(case=case).force_kN * 1000, 1) }} of {{ table.row(case=case).force_kN }} |\n% endfor\n',
        "docs/make/pages/tables/sentence.j2": '% set ladder = csv("docs/charts/ladder.csv")\n% set r = ladder.row(rung="full")\n'
        'It is off by {{ f(r.error * ladder.percent, 1) }} %, {{ f(r.error * degrees, 2) }}°, {{ csv("docs/report.md").row(check="one \\\\| other").off }}.\n'}
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.setattr(write, "ROOT", tmp_path)
    monkeypatch.setattr(write.ENVIRONMENT, "loader", write.jinja2.FileSystemLoader(tmp_path / "docs/make/pages/tables"))
    monkeypatch.setattr(write.ENVIRONMENT, "cache", None)
    return tmp_path


def spoiled(tree, capsys, name, before, after):
    """What --check says of the tree with this change."""
    text = (tree / name).read_text()
    assert before in text
    (tree / name).write_text(text.replace(before, after))
    capsys.readouterr()
    assert write.main(["--check"]) == 1
    (tree / name).write_text(text)
    return capsys.readouterr().out


def test_tables(tree, capsys):
    assert write.main(["--check"]) == 1
    assert write.main([]) == 0 and write.main(["--check"]) == 0
    assert (tree / "README.md").read_text() == (
        "All:\n\n<!-- table forces -->\n\n| case | force [N] |\n|---|---|\n| one | 12.3 of 0.01234 |\n| two | 5000.0 of 5 |\n\n"
        "Made at commit `0123abc` ([force.csv](docs/charts/force.csv)).\n\n<!-- end of table forces -->\n\nEnd.\n")
    assert "\n\nIt is off by 2.5 %, 2.86°, 0.03 m.\n\n" in (tree / "docs/page.md").read_text()
    force, page, template = "docs/charts/force.csv", "README.md", "docs/make/pages/tables/forces.j2"
    for name, before, after, says in (
            (page, "12.3", "12.4", "README.md says something else"), (page, "`0123abc`", "`0123abd`", "README.md says something else"),
            (page, "<!-- end of table forces -->\n", "", "without the other mark"), (page, "<!-- table forces -->", "", "without the other mark"),
            (page, "table forces", "table force", "TemplateNotFound"), (force, "0.01234", "0.01244", "README.md says something else"),
            (force, "one,0.01234", "one,", "nothing in the column force_kN"), (force, "one,", "two,", "0 rows"), (force, "_kN", "_MN", "nothing in the column"),
            (template, "force.csv", "gone.csv", "FileNotFoundError"), (template, "csv(", "cvs(", "UndefinedError"),
            ("docs/charts/ladder.csv", "from: 3", "from: 2", "docs/page.md says something else"),
            ("docs/page.md", "text sentence", "text other", "no page has this table")):
        assert says in spoiled(tree, capsys, name, before, after), (name, before, after)


def test_heads(tree, capsys):
    write.main([])
    for before, after, says in (("# machine: M, 2 cores\n", "", "do not name its machine"), ("(0123abc,", "(unknown,", "of which no commit tells"),
                                ("(0123abc,", "(0123abc-dirty,", "of which no commit tells"), (HEAD, "# machine: M\n# commit: 0123abc\n", "its compiler")):
        assert says in spoiled(tree, capsys, "docs/charts/force.csv", before, after)


def test_gallery(tmp_path, monkeypatch, capsys):
    text = gallery.page()
    assert text == gallery.PAGE.read_text(encoding="utf-8")
    (tmp_path / "page.md").write_text(text.replace("## [rigid_tank]", "## [other]"), encoding="utf-8")
    monkeypatch.setattr(gallery, "PAGE", tmp_path / "page.md")
    assert gallery.main(["--check"]) == 1 and "differs from the cases" in capsys.readouterr().out


# Each change of these rows and what the check says of it; the rows as they are say nothing.
NEAR = ["near", "Tank.fill", "verification/gas/tank_test.cpp", "G.6", "pressure [Pa]", "order 4", "100001", "100000", "10"]
ORDER = ["order", "Tank.order", "verification/gas/tank_test.cpp", "G.9", "mass", "of the scheme", "-0.04 -0.01", "2.0", "1.9", "2.1"]
THRESHOLD = ["threshold", "Step.blows_up", "verification/membrane/step_test.cpp", "M.12", "drum", "bisection", "critical step", "2/omega", "0.01", "0.0101",
             "s", "1", "1.05", "exit 3"]


def tables_of(make, tmp_path, rows):
    (tmp_path / "rows.tsv").write_text("".join("\t".join(row) + "\n" for row in rows))
    return make(claims.rows_of(tmp_path))


def changed(row, field, text):
    return [*row[:field], text, *row[field + 1:]]


def test_verification(tmp_path):
    def drift(*rows):
        return "\n".join(claims.verification_drift(page, tables_of(claims.verification_tables, tmp_path, rows)))
    page = tables_of(claims.verification_tables, tmp_path, [NEAR, ORDER])
    assert "| pressure [Pa] | 100001 | 100000 | 1.0e-05 | 1.0e-04 | order 4 | 1 |  | [Tank.fill](../verification/gas/tank_test.cpp) |" in page
    assert "| mass | -4.00e-02 -1.00e-02 | 2.00 | 1.9 to 2.1 | of the scheme | 1 |" in page
    proved = tables_of(claims.verification_tables, tmp_path, [changed(NEAR, 1, "blowdown.eq_closed_form_for_every_parameter")])
    assert "| order 4 | 1 | [`blowdown`](exact.md) | [blowdown.eq" in proved and "(exact.md)" not in page
    # A sweep shows the check that uses most of its tolerance.
    assert "| 100005 | 100000 | 5.0e-05 | 1.0e-04 | order 4 | 2 |" in tables_of(claims.verification_tables, tmp_path, [NEAR, changed(NEAR, 6, "100005")])
    assert drift(NEAR, ORDER) == "" and "no test says this any more" in drift(NEAR) and "not in the report" in drift(NEAR, ORDER, changed(ORDER, 4, "x"))
    for field, text, says in ((6, "100009", "error is"), (6, "100011", "more than allowed"), (7, "99999.8", "exact is"), (8, "11", "allowed is")):
        assert says in drift(changed(NEAR, field, text), ORDER)
    for field, text, says in ((7, "2.06", "orders are"), (6, "-0.04 -0.011", "errors are"), (7, "2.0 2.0", "other levels")):
        assert says in drift(NEAR, changed(ORDER, field, text))


def test_stability(tmp_path):
    def drift(*rows):
        return "\n".join(claims.stability_drift(page, tables_of(claims.stability_tables, tmp_path, rows)))
    page = tables_of(claims.stability_tables, tmp_path, [THRESHOLD])
    assert "| critical step: drum | [M.12]" in page and "2/omega | 0.01 s | 0.0101 s | 1.0100 | 1 to 1.05: bisection | exit 3 |" in page
    assert drift(THRESHOLD) == "" and "no test says" in drift() and "not in the atlas" in drift(THRESHOLD, changed(THRESHOLD, 4, "ball"))
    for field, text, says in ((8, "0.01002", "predicted is"), (9, "0.0102", "ratio is"), (12, "1.06", "reads otherwise"), (13, "exit 2", "reads otherwise")):
        assert says in drift(changed(THRESHOLD, field, text))


def test_api_pages(tmp_path, monkeypatch):
    """Every public name once, with its words; what has none is refused."""
    headers = "".join(file.read_text() for file in api_pages.HEADERS)
    functions = set(re.findall(r"^GASJET_API [^(]*?(\w+)\(", headers, re.M))
    assert len(functions) == headers.count("\nGASJET_API ") > 80
    structures = set(re.findall(r"typedef struct (\w+)", headers))
    for page, more in ((api_pages.c_page(), {"gasjet_handle", "gasjet_status"}), (api_pages.fortran_page(), {"gasjet_message"})):
        listed = [name for names in re.findall(r"^### (.*)$", page, re.M) for name in names.split(", ")]
        assert functions | structures | more <= set(listed) and len(listed) == len(set(listed))
        assert page.count("```") % 2 == 0 and "Pressure ratio at which a hole chokes (G.5), gamma > 1.".replace(">", "\\>") in page
    assert "### gasjet_gas_temperature\n\n```c\nint gasjet_gas_temperature(gasjet_handle gas, double internal_energy, double* temperature);\n```\n" in api_pages.c_page()
    python = api_pages.python_page()
    assert "gasjet.mesh(kind: str, " in python and "Simulation.drift: float\n```\n\nLargest drift" in python and "Gas.ideal(gas_constant: float" in python
    (tmp_path / "__init__.py").write_text('"""Words."""\n__all__ = ["f"]\n')
    monkeypatch.setattr(api_pages, "PACKAGE", tmp_path)
    for text, says in (("def f(): ...\n", "gasjet.f has no docstring"), ("def g(): ...\n", "gasjet.f is in __all__")):
        (tmp_path / "f.py").write_text(text)
        with pytest.raises(SystemExit, match=says):
            api_pages.python_page()
