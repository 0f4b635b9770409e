# SPDX-License-Identifier: Apache-2.0
"""Studies whose factors are random: percentiles, chances, correlations and effects against closed forms and SciPy."""
import pytest
from command import expect, has, load, ok, read, refused, table
from plans import TANK, factor, flow, tank_plan, plan

np = pytest.importorskip("numpy", reason="python3-numpy is missing")
stats = pytest.importorskip("scipy.stats", reason="python3-scipy is missing")
NORMAL = ('distribution = "normal"', "mean = 0.1", "standard_deviation = 0.005")
CUT = ('distribution = "truncated_normal"', "mean = 0.1", "standard_deviation = 0.005", "low = 0.098", "high = 0.107")
TRIANGULAR = ('distribution = "triangular"', "low = 0.09", "mode = 0.095", "high = 0.12")
LOG_NORMAL = ('distribution = "log_normal"', "median = 0.1", "deviation_factor = 1.06")
FOREIGN = {NORMAL: stats.norm(0.1, 0.005), CUT: stats.truncnorm(-0.4, 1.4, 0.1, 0.005), TRIANGULAR: stats.triang(1 / 6, 0.09, 0.03),
           LOG_NORMAL: stats.lognorm(np.log(1.06), scale=0.1)}


def design(points, kind="sobol"):
    return f'design = "{kind}"', f"points = {points}"


def limit(line, quantity="pressure_Pa"):
    return "[[limit]]", f'quantity = "{quantity}"', line


def pair(coefficient, *more, names=("flow", "warm")):
    return "[[correlation]]", f'factors = ["{names[0]}", "{names[1]}"]', f"coefficient = {coefficient}", *more


def column(folder, name):
    return np.array([float(row[name]) for row in table(f"{folder}/results.csv")])


def statistics(folder, quantity="pressure_Pa"):
    """Rows of spread.csv by their statistic: value, low, high."""
    number = lambda text: float(text) if text else None
    return {row["statistic"]: [number(row[name]) for name in ("value", "low", "high")]
            for row in table(f"{folder}/spread.csv") if row["quantity"] == quantity}


def pressure_of_flow():
    """The closed tank's pressure, which is linear in the flow of a gas of constant heat capacity."""
    plan('quantities = ["pressure_Pa"]', *flow("values = [0.05, 0.15]"), to="ends.toml")
    ok("study run ends.toml --out ends --quiet")
    low, high = column("ends", "pressure_Pa")
    return lambda x: low + (high - low) * (x - 0.05) / 0.1


@pytest.mark.parametrize("lines", FOREIGN, ids=lambda lines: lines[0].split('"')[1])
def test_study_spread_percentiles(lines):
    """Percentiles and chances are those of the distribution, carried through a linear quantity; the error falls with the runs."""
    pressure, truth = pressure_of_flow(), FOREIGN[lines]
    border = pressure(truth.ppf(0.9))
    errors = []
    for points in (127, 1023):
        out = f"out{points}"
        tank_plan(*design(points), *flow(*lines), *limit(f"above = {border}"), *limit(f"below = {border}"))
        expect(0, "pressure_Pa: mean .*percentiles 5, 50, 95: (?s:.*)above .* % of the runs, 95 % interval", f"study run plan.toml --out {out}")
        # Sobol's first 2^m - 1 numbers are 1/2^m apart; a row prints all digits of its factor.
        units = np.arange(1, points + 1) / (points + 1)
        assert np.sort(column(out, "inflator.0.mass_flow")) == pytest.approx(truth.ppf(units), rel=1e-13)
        found = statistics(out)
        for share in (0.05, 0.25, 0.5, 0.75, 0.95):
            value, low, high = found[f"percentile_{100 * share:g}"]
            exact = pressure(truth.ppf(share))
            assert low < exact < high
            errors.append((points, abs(truth.cdf(truth.ppf(0.5) + (value - pressure(truth.ppf(0.5))) / (pressure(1) - pressure(0))) - share)))
        value, low, high = found["chance_above"]
        assert low < 0.1 < high and value == pytest.approx(0.1, abs=1 / points)
        assert found["chance_below"][0] == pytest.approx(1 - value, abs=1e-12)
        mean, low, high = found["mean"]
        assert low < pressure(truth.mean()) < high
        assert found["standard_deviation"][0] == pytest.approx((pressure(1) - pressure(0)) * truth.std(), rel=3 / np.sqrt(2 * points))
    for points in (127, 1023):  # even points: a percentile's share is wrong by one point at most, order 1/n
        assert max(error for n, error in errors if n == points) < 1 / points


def test_study_spread_of_scipy():
    """Of the same runs SciPy and NumPy find the same percentiles, intervals and chances."""
    warm = factor("inflator.0.temperature", 'name = "warm"', "range = [350, 450]")
    tank_plan(*design(90, "latin_hypercube"), *flow(*NORMAL), *warm, *limit("above = 1.3e5"))
    ok("study run plan.toml --out out --quiet")
    values, found = column("out", "pressure_Pa"), statistics("out")
    for percent in (5, 25, 50, 75, 95):
        value, low, high = found[f"percentile_{percent}"]
        assert value == pytest.approx(np.percentile(values, percent, method="hazen"), rel=1e-14)
        counts = stats.binom(90, percent / 100)  # of the values below the percentile
        assert (low, high) == (np.sort(values)[int(counts.ppf(0.025)) - 1], np.sort(values)[int(counts.ppf(0.975))])
    assert found["mean"][0] == pytest.approx(values.mean(), rel=1e-14)
    assert found["standard_error"][0] == pytest.approx(stats.sem(values), rel=1e-12)
    assert found["standard_deviation"][0] == pytest.approx(values.std(ddof=1), rel=1e-12)
    assert found["mean"][1:] == pytest.approx(stats.t.interval(0.95, 89, values.mean(), stats.sem(values)), rel=1e-12)
    beyond = int((values > 1.3e5).sum())
    theirs = stats.binomtest(beyond, 90).proportion_ci(0.95, "exact")
    assert 0 < beyond < 90 and found["chance_above"] == pytest.approx([beyond / 90, theirs.low, theirs.high], rel=1e-10)
    # Shares of the variance: one-factor quadratics, adjusted.
    for name, row in {row["factor"]: row for row in table("out/effects.csv")}.items():
        x = column("out", name)
        left = np.sum((values - np.polyval(np.polyfit(x - x.mean(), values, 2), x - x.mean())) ** 2) / np.sum((values - values.mean()) ** 2)
        assert float(row["share"]) == pytest.approx(1 - left * 89 / 87, abs=1e-9)
        assert float(row["share_low"]) < float(row["share"]) < float(row["share_high"])
    json = load("out/study.json")["spread"]["pressure_Pa"]
    assert json["percentiles"]["95"]["high"] == found["percentile_95"][2]
    assert json["limits"] == [dict(zip(("above", "chance", "low", "high"), (1.3e5, *found["chance_above"])))]
    # The same bytes from shares.
    for share in ("2/2", "1/2"):
        ok(f"study run plan.toml --out shares --quiet --share {share}")
    ok("study merge shares")
    assert read("shares/spread.csv") == read("out/spread.csv") and read("shares/effects.csv") == read("out/effects.csv")


@pytest.mark.parametrize("of, coefficient", [("normal_scores", 0.7), ("ranks", -0.5)])
def test_study_spread_correlation(of, coefficient):
    """A Gaussian copula: its coefficient is recovered, and each number is that of the mixed normal numbers."""
    flows, warm = flow('name = "flow"', *TRIANGULAR), factor("inflator.0.temperature", 'name = "warm"', 'distribution = "log_normal"', "median = 400",
                                                             "deviation_factor = 1.02")
    rho = coefficient if of == "normal_scores" else 2 * np.sin(np.pi / 6 * coefficient)
    for kind, points in (("sobol", 511), ("latin_hypercube", 400)):
        tank_plan(*design(points, kind), *flows, *warm)
        ok(f"study run plan.toml --out free_{kind} --quiet")
        tank_plan(*design(points, kind), *flows, *warm, *pair(coefficient, f'of = "{of}"'), to="pair.toml")
        ok(f"study run pair.toml --out pair_{kind} --quiet")
        x, y, free = column(f"pair_{kind}", "flow"), column(f"pair_{kind}", "warm"), column(f"free_{kind}", "warm")
        of_warm = stats.lognorm(np.log(1.02), scale=400)
        assert list(x) == list(column(f"free_{kind}", "flow"))
        a, b = stats.norm.ppf(FOREIGN[TRIANGULAR].cdf(x)), stats.norm.ppf(of_warm.cdf(free))
        assert y == pytest.approx(of_warm.ppf(stats.norm.cdf(rho * a + np.sqrt(1 - rho**2) * b)), rel=1e-12)
        found = stats.spearmanr(x, y)[0] if of == "ranks" else stats.pearsonr(a, np.log(y))[0]
        assert found == pytest.approx(coefficient, abs=2 / np.sqrt(points))
    # The margin is still the log-normal one (Kolmogorov and Smirnov), and what each factor explains has part of the other's share.
    assert stats.kstest(y, of_warm.cdf).pvalue > 0.01
    effects = {folder: {row["factor"]: row for row in table(f"{folder}_sobol/effects.csv")} for folder in ("free", "pair")}
    a, b = (float(effects["free"][name]["change_per_deviation"]) for name in ("flow", "warm"))
    for name, alone in (("flow", a + rho * b), ("warm", b + rho * a)):  # of a sum of two correlated numbers; the product adds little
        assert float(effects["pair"][name]["share"]) == pytest.approx(alone**2 / (a * a + b * b + 2 * rho * a * b), abs=0.03)


def test_study_spread_left_out():
    """Runs without a value are in no percentile, and few points leave ends of intervals open."""
    plan('set = ["scene.end_time=1e-3"]', *design(24), *factor("time.step", "range = [1e-5, 2e-4]", 'scale = "logarithmic"'),
         case="cases/sphere_inflation.toml")
    expect(3, "spread.csv, peak_pressure_Pa: [0-9]+ of 24 runs have no value", "study run plan.toml --out out")
    rows = [row for row in table("out/spread.csv") if row["quantity"] == "peak_pressure_Pa"]
    done = sum(row["status"] == "done" for row in table("out/results.csv"))
    assert 2 < done < 24 and {(row["points"], row["runs"], row["left_out"]) for row in rows} == {(str(done), str(done), str(24 - done))}
    assert statistics("out", "peak_pressure_Pa")["percentile_5"][1] is None
    assert has("out/spread.csv", "peak_volume_m3,percentile_50")


def test_study_spread_of_indices():
    """Of a design for Sobol indices the two independent points of each row count, and sobol.csv has the effects."""
    tank_plan(*design(64, "sobol_indices"), *flow(*NORMAL), *factor("ambient.temperature", "range = [290, 300]"))
    ok("study run plan.toml --out out --quiet")
    samples = [value for i, value in enumerate(column("out", "pressure_Pa")) if i % 4 < 2]
    value = statistics("out")["percentile_75"][0]
    assert len(samples) == 128 and value == pytest.approx(np.percentile(samples, 75, method="hazen"), rel=1e-14)
    assert not has("out/effects.csv") and has("out/sobol.csv")


def test_study_spread_pictures():
    tank_plan(*design(63), *flow('name = "flow"', *NORMAL), *factor("inflator.0.temperature", 'name = "warm"', "range = [100, 1100]", 'scale = "logarithmic"'),
              "[analysis]", "pictures = true", "response_surface = true")
    expect(0, "63 of 63 runs", "study run plan.toml --out out")
    assert "notes" not in load("out/study.json")
    for name in ("means", "surface"):
        assert "flow" in read(f"out/{name}.svg") and "warm" in read(f"out/{name}.svg")
    commands = read("out/means.gp")
    assert commands.count("\nset logscale x") == 1 and commands.count("\nplot ") == 2 and commands.count("$trend_0_1 << EOD") == 1
    # The surface's drawn corner: coefficients of the table, each factor at its least.
    terms = {row["term"]: float(row["coefficient"]) for row in table("out/surface.csv")}
    corner = terms["1"] - terms["flow"] - terms["warm"] + terms["flow * warm"] + terms["flow * flow"] + terms["warm * warm"]
    first = read("out/surface.gp").partition("<< EOD\n")[2].split("\n")[0].split()
    assert float(first[0]) == pytest.approx(column("out", "flow").min(), rel=1e-12) and float(first[1]) == pytest.approx(100, rel=1e-12)
    assert float(first[2]) == pytest.approx(corner, rel=1e-12)


AT = "plan.toml"
WARM = factor("inflator.0.temperature", 'name = "warm"', "range = [300, 400]")


def normal(**changes):
    values = {"mean": 0.1, "standard_deviation": 0.005} | changes
    return [f"{key} = {value}" for key, value in values.items()]


@pytest.mark.parametrize("says, lines", [
    (f"{AT}:10:1: factor.0.standard_deviation: is 0, allowed: a number above 0",
     (*design(9), *flow('distribution = "normal"', *normal(standard_deviation=0)))),
    (f"{AT}:10:1: factor.0.standard_deviation: is -1, allowed: a number above 0",
     (*design(9), *flow('distribution = "normal"', *normal(standard_deviation=-1)))),
    ("factor.0.mean: is missing", (*design(9), *flow('distribution = "normal"', "standard_deviation = 1"))),
    (f"{AT}:12:1: factor.0.high: is 0.05, allowed: above low = 0.15",
     (*design(9), *flow('distribution = "truncated_normal"', *normal(low=0.15, high=0.05)))),
    (f"{AT}:11:1: factor.0.low: to high has 0 of the distribution, allowed: 1e-06 or more",
     (*design(9), *flow('distribution = "truncated_normal"', *normal(low=0.5, high=0.6)))),
    (f"{AT}:10:1: factor.0.mode: is 0.3, allowed: from low = 0.1 to high = 0.2",
     (*design(9), *flow('distribution = "triangular"', "low = 0.1", "mode = 0.3", "high = 0.2"))),
    (f"{AT}:11:1: factor.0.high: is 0.1, allowed: above low = 0.1",
     (*design(9), *flow('distribution = "triangular"', "low = 0.1", "mode = 0.1", "high = 0.1"))),
    ("factor.0.deviation_factor: is 1, allowed: a number above 1",
     (*design(9), *flow('distribution = "log_normal"', "median = 1", "deviation_factor = 1"))),
    ("factor.0.median: is 0, allowed: a number above 0", (*design(9), *flow('distribution = "log_normal"', "median = 0", "deviation_factor = 2"))),
    ('factor.0.distribution: is "gaussian", allowed: one of "?normal', (*design(9), *flow('distribution = "gaussian"'))),
    ("factor.0.range: is given with a distribution: leave out", (*design(9), *flow('distribution = "normal"', *normal(), "range = [1, 2]"))),
    ("factor.0.low: unknown key", (*design(9), *flow('distribution = "normal"', *normal(), "low = 0.1"))),
    ("study.design: needs values of each factor", flow(*NORMAL)),
    (r'factor.0: with "-[0-9.]+" the case is refused: .*mass_flow: is -', (*design(63), *flow('distribution = "normal"', *normal(standard_deviation=0.1)))),
    (f"{AT}:16:1: correlation.0.coefficient: is 1.2, allowed: -0.999 to 0.999",
     (*design(9), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(1.2))),
    (f'{AT}:15:1: correlation.0.factors: has "cold", allowed: factors with a distribution or a range: flow, warm',
     (*design(9), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(0.5, names=("flow", "cold")))),
    ("correlation.0.factors: is not a pair", (*design(9), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(0.5, names=("flow", "flow")))),
    ("correlation.1.factors: has warm and flow, which have a correlation already",
     (*design(9), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(0.5), *pair(0.4, names=("warm", "flow")))),
    ("correlation: has coefficients that no factors have all together",
     (*design(9), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *factor("tank.volume", 'name = "room"', "range = [0.05, 0.06]"),
      *pair(0.9), *pair(0.9, names=("warm", "room")), *pair(-0.9, names=("flow", "room")))),
    ('study.design: "sobol_indices" needs independent factors', (*design(9, "sobol_indices"), *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(0.5))),
    ("study.design: takes no ..correlation.., allowed with it",
     ('design = "list"', *flow('name = "flow"', "range = [0.1, 0.2]"), *WARM, *pair(0.5))),
    (f'{AT}:10:1: limit.0.quantity: is "mass", allowed: one of the study\'s quantities pressure_Pa',
     (*design(9), *flow("range = [0.1, 0.2]"), *limit("above = 1", "mass"))),
    ("limit.0.above: is missing, needed: it or below", (*design(9), *flow("range = [0.1, 0.2]"), "[[limit]]", 'quantity = "pressure_Pa"')),
    ("limit.0.below: is given with above", (*design(9), *flow("range = [0.1, 0.2]"), *limit("above = 1"), "below = 2")),
    ("limit.0: needs a design whose points are samples", (*flow("values = [0.1, 0.2]"), *limit("above = 1"))),
], ids=lambda value: value[:50] if isinstance(value, str) else "")
def test_study_spread_bad(says, lines):
    tank_plan(*lines)
    refused(says, "study run plan.toml --out none")
