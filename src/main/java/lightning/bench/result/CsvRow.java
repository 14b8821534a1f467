package lightning.bench.result;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.ArrayList;
import java.util.List;
import lightning.base.text.DecimalNumber;
import lightning.render.measure.PictureError;
import org.jspecify.annotations.Nullable;

/**
 * Measurement as a CSV row. Text that a spreadsheet would evaluate gets an apostrophe prefix. Missing values are NaN, 0 or empty.
 *
 * @param kind  {@code first-pass}, {@code full-trace}, {@code edit}, {@code peer}, {@code effect} (added time of the first pass), {@code
 *         growth}, {@code drift}, {@code editing}, {@code mesh} or {@code mesh-peer}. Cold-start processes are {@code cold} (ours) and
 *         {@code cold-peer}, with processor times as {@code …-processor}. Those of the modern set start with {@code modern-},
 *         those of indirect light with {@code indirect-}
 * @param edit  name of the edit; of growth, dimension and edit; of editing, the operation; of a mesh, its BVH or the rays
 * @param value value of the edit; of growth and drift, the number of pixels, lights, … or edits
 * @param grade accuracy setting, called level in the file
 * @param n     number of samples of the median and the quartiles
 */
record CsvRow(String kind, String scene, int width, int height, String edit, String value, @JsonProperty("level") String grade,
        int n, double medianMs,
        double lowerQuartileMs, double upperQuartileMs, double savingPercent, double capPercent, double paperPercent, String plan,
        long rowsTouched, long shadowRays, long shadowRaysAvoided, long bytesMoved, double floorMs, double timesFloor,
        long valuesThatDiffer, long maxUlp, double maxAbsolute, double meanAbsolute, double rmse, double linearPsnrDb,
        double displayPsnrDb, double ssim, double flip, double bound) {

    private static final String FORMULA_STARTS = "=+-@\t\r\n'\uFF1D\uFF0B\uFF0D\uFF20";
    private static final double NONE = Double.NaN;
    static final UpdateWork NO_WORK = new UpdateWork("", 0, 0, 0, 0, 0, NONE, NONE, NONE, NONE);
    static final PictureError NO_ERROR = new PictureError(0, 0, 0, NONE, NONE, NONE, NONE, NONE, NONE, NONE);
    private static final TimeSamples NO_SAMPLES = new TimeSamples(NONE, NONE, NONE, List.of());

    /** Returns the rows of results in order. */
    static List<CsvRow> of(BenchResults results) {
        List<CsvRow> rows = new ArrayList<>();
        for (SceneResult scene : results.scenes()) {
            if (scene.firstPass() != null) {
                rows.add(trace("first-pass", scene, "", scene.firstPass().time()));
                rows.add(trace("full-trace", scene, "", scene.firstPass().fullTrace()));
            }
            if (scene.peer() != null) {
                rows.add(trace("peer", scene, scene.peer().program(), scene.peer().time()));
            }
            if (scene.cold() != null) {
                cold(rows, scene, scene.cold());
            }
            scene.effects().forEach(effect -> rows.add(effect(scene, effect)));
            for (EditResult edit : scene.edits()) {
                edit.values().forEach(value -> value.rungs().forEach(point -> rows.add(edit(scene, edit, value, point))));
            }
        }
        results.growth().forEach(growth -> growth.points().forEach(point -> {
            rows.add(growth(growth, point, "full-trace", point.fullTrace()));
            point.edits().forEach(edit -> rows.add(growth(growth, point, edit.edit(), edit.time())));
        }));
        results.editing().forEach(editing -> editing(rows, editing));
        results.meshes().forEach(mesh -> mesh(rows, mesh));
        results.modern().forEach(scene -> rows.addAll(ModernCsvRows.of(scene)));
        rows.addAll(IndirectCsvRows.of(results.indirect()));
        results.drift().forEach(drift -> drift.points().forEach(point -> rows.add(drift(drift, point))));
        return rows;
    }

    private static void cold(List<CsvRow> rows, SceneResult scene, ColdStart cold) {
        process(rows, scene, "cold", "", cold.process(), cold.processor());
        if (cold.rival() != null) {
            process(rows, scene, "cold-peer", cold.rival().program(), cold.rival().process(), cold.rival().processor());
        }
    }

    private static void process(List<CsvRow> rows, SceneResult scene, String kind, String program, TimeSamples wall,
            @Nullable TimeSamples processor) {
        rows.add(trace(kind, scene, program, wall));
        if (processor != null) {
            rows.add(trace(kind + "-processor", scene, program, processor));
        }
    }

    private static CsvRow trace(String kind, SceneResult scene, String value, TimeSamples time) {
        return row(kind, scene.scene(), scene.width(), scene.height(), "", value, "", time, NONE, NONE, NO_WORK, NO_ERROR);
    }

    private static CsvRow effect(SceneResult scene, EffectResult effect) {
        return row("effect", scene.scene(), scene.width(), scene.height(), effect.effect(), effect.inUse() ? "in use" : "absent", "",
                new TimeSamples(effect.firstMs(), NONE, NONE, List.of()), NONE, NONE, NO_WORK, NO_ERROR);
    }

    private static CsvRow edit(SceneResult scene, EditResult edit, ValueResult value, SweepPointResult point) {
        return row("edit", scene.scene(), scene.width(), scene.height(), edit.edit(), value.value(), point.grade().label(), point.time(),
                point.saving(), edit.paperSaving(), point.work() == null ? NO_WORK : point.work(), point.error());
    }

    private static CsvRow growth(GrowthCurve growth, GrowthPoint point, String edit, TimeSamples time) {
        return row("growth", growth.scene(), 0, 0, growth.along() + ": " + edit, Long.toString(point.at()), "", time, NONE, NONE,
                NO_WORK, NO_ERROR);
    }

    private static void editing(List<CsvRow> rows, EditingCost e) {
        rows.add(editing(e, "load", e.load()));
        rows.add(editing(e, "tree", e.tree()));
        rows.add(editing(e, "new scene", e.newScene()));
        rows.add(editing(e, "plan", e.plan()));
        rows.add(editing(e, "first hover", e.hover()));
    }

    private static CsvRow editing(EditingCost e, String name, TimeSamples time) {
        return row("editing", e.shapes() + " shapes, " + e.lights() + " lights", 0, 0, name, "", "", time, NONE, NONE, NO_WORK, NO_ERROR);
    }

    private static void mesh(List<CsvRow> rows, MeshPoint m) {
        rows.add(mesh("mesh", m, "tree", m.tree()));
        if (m.rival() != null) {
            rows.add(mesh("mesh-peer", m, "tree", m.rival().tree()));
        }
        for (RayThroughput pace : m.rays()) {
            rows.add(mesh("mesh", m, pace.rays(), pace.time()));
            if (pace.rival() != null) {
                rows.add(mesh("mesh-peer", m, pace.rays(), pace.rival()));
            }
        }
    }

    private static CsvRow mesh(String kind, MeshPoint m, String name, TimeSamples time) {
        return row(kind, m.triangles() + " triangles", 0, 0, name, "", "", time, NONE, NONE, NO_WORK, NO_ERROR);
    }

    private static CsvRow drift(DriftCurve drift, DriftPoint point) {
        UpdateWork bound = new UpdateWork("", 0, 0, 0, 0, 0, NONE, NONE, NONE, point.bound());
        return row("drift", drift.scene(), drift.width(), drift.height(), "", Integer.toString(point.edits()),
                point.setting(), NO_SAMPLES, NONE, NONE, bound, point.error());
    }

    static CsvRow row(String kind, String scene, int width, int height, String edit, String value, String setting, TimeSamples time,
            double saving, double paper, UpdateWork work, PictureError e) {
        return new CsvRow(cell(kind), cell(scene), width, height, cell(edit), cell(value), cell(setting), time.samples().size(),
                time.median(), time.lowerQuartile(),
                time.upperQuartile(), saving, work.cap(), paper, cell(work.plan()), work.rowsTouched(), work.shadowRays(),
                work.shadowRaysAvoided(), work.bytesMoved(), work.floorMs(), work.timesFloor(), e.values(), e.maxUlp(), e.maxAbsolute(),
                e.meanAbsolute(), e.rmse(), e.linearPsnr(), e.displayPsnr(), e.ssim(), e.flip(), work.errorBound());
    }

    /**
     * Escapes text for a cell. Spreadsheets evaluate text that starts with = + - @ (or their wide forms), also after a tab or line end; an
     * apostrophe prefix prevents that. An apostrophe of the text itself also gets the prefix, so that removing the first one restores the
     * text. Numbers stay unchanged.
     */
    static String cell(String text) {
        boolean isFormula = !text.isEmpty() && FORMULA_STARTS.indexOf(text.charAt(0)) >= 0 && DecimalNumber.parse(text).isEmpty();
        return isFormula ? "'" + text : text;
    }
}
