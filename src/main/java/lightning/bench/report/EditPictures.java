package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import lightning.bench.EditResult;
import lightning.bench.RungResult;
import lightning.bench.SceneResult;
import lightning.bench.ValueResult;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.PictureError;

/** Each edit by itself: its pictures to wipe between, its grades, its error against time. */
final class EditPictures {
    /** A picture with the words for it. */
    private record Shown(String name, String style, Grade grade) {}

    private EditPictures() {}

    static void write(Markup page, String id, SceneResult scene, PictureBook book) {
        for (int i = 0; i < scene.edits().size(); i++) {
            EditResult edit = scene.edits().get(i);
            if (!edit.values().isEmpty()) {
                page.open("details", "class", "edit", "id", id + "-edit-" + (i + 1), "open", i == 0 ? "open" : null);
                page.open("summary").leaf("b", edit.edit()).text(" " + headline(edit)).close();
                pictures(page, scene, edit.values().getFirst(), book);
                edit.values().forEach(value -> value(page, edit, value));
                page.close();
            }
        }
    }

    private static String headline(EditResult edit) {
        return (edit.figure().isEmpty() ? "" : edit.figure() + " · ") + "saves " + Numbers.percent(edit.saving())
                + (Double.isNaN(edit.paperSaving()) ? "" : ", the paper " + Numbers.percent(edit.paperSaving()));
    }

    private static void pictures(Markup page, SceneResult scene, ValueResult value, PictureBook book) {
        List<Shown> shown = new ArrayList<>();
        List<Shown> differences = new ArrayList<>();
        add(shown, "before", book.picture(scene.before()), null);
        for (RungResult rung : value.rungs()) {
            add(shown, rung.grade().label(), book.picture(rung.picture()), rung.grade());
            add(differences, rung.grade().label(), book.difference(rung.difference()), rung.grade());
        }
        if (shown.size() < 2) {
            return;
        }
        String shape = String.format(Locale.ROOT, "aspect-ratio:%d/%d", scene.width(), scene.height());
        int after = index(shown, Grade.DEFAULT, index(shown, Grade.EXACT, shown.size() - 1));
        wipe(page, shown, differences, after, shape);
        side(page, shown, differences, after, shape);
    }

    private static void add(List<Shown> to, String name, String style, Grade grade) {
        if (style != null) {
            to.add(new Shown(name, style, grade));
        }
    }

    private static int index(List<Shown> shown, Grade grade, int otherwise) {
        for (int i = 0; i < shown.size(); i++) {
            if (shown.get(i).grade == grade) {
                return i;
            }
        }
        return otherwise;
    }

    /** For the screen. */
    private static void wipe(Markup page, List<Shown> shown, List<Shown> differences, int after, String shape) {
        page.open("div", "class", "wipe");
        page.open("div", "class", "view");
        page.open("div", "class", "stage", "style", shape);
        page.leaf("div", "", "class", "pic right " + shown.get(after).style).leaf("div", "", "class", "pic left " + shown.getFirst().style);
        page.empty("input", "type", "range", "class", "cut", "min", "0", "max", "100", "value", "50", "step", "0.1", "aria-label", "wipe");
        page.close();
        page.open("div", "class", "controls");
        select(page, "left", shown, 0);
        page.open("label").text("exposure ").empty("input", "type", "range", "class", "exposure", "min", "-6", "max", "6", "value", "0",
                "step", "0.25").leaf("output", "0 EV").close();
        select(page, "right", shown, after);
        page.close().close();
        page.open("div", "class", "view");
        page.open("div", "class", "stage", "style", shape);
        page.leaf("p", "equal in every bit", "class", "equal");
        int of = index(differences, shown.get(after).grade, -1);
        page.leaf("div", "", "class", "pic difference " + (of < 0 ? "" : differences.get(of).style));
        page.close();
        page.open("div", "class", "controls").open("label").text("difference to the full trace ");
        page.open("select", "class", "of", "aria-label", "difference of which grade");
        for (Shown s : shown) {
            if (s.grade != null && s.grade != Grade.FULL_TRACE) {
                int i = index(differences, s.grade, -1);
                page.leaf("option", s.name, "value", i < 0 ? "" : differences.get(i).style, "selected",
                        s == shown.get(after) ? "selected" : null);
            }
        }
        page.close().close();
        page.open("span", "class", "scale").leaf("i", "").text("2⁻²⁴ to 1").close().close().close().close();
    }

    private static void select(Markup page, String side, List<Shown> shown, int chosen) {
        page.open("select", "class", side, "aria-label", side + " picture");
        for (int i = 0; i < shown.size(); i++) {
            page.leaf("option", shown.get(i).name, "value", shown.get(i).style, "selected", i == chosen ? "selected" : null);
        }
        page.close();
    }

    /** For paper, and where no script runs: the same side by side. */
    private static void side(Markup page, List<Shown> shown, List<Shown> differences, int after, String shape) {
        page.open("div", "class", "side");
        picture(page, shown.getFirst().name, shown.getFirst().style, shape);
        picture(page, shown.get(after).name, shown.get(after).style, shape);
        int full = index(shown, Grade.FULL_TRACE, -1);
        if (full >= 0 && full != after) {
            picture(page, shown.get(full).name, shown.get(full).style, shape);
        }
        int of = index(differences, shown.get(after).grade, -1);
        if (of >= 0) {
            picture(page, "difference, false colours", differences.get(of).style, shape);
        }
        page.close();
    }

    private static void picture(Markup page, String name, String style, String shape) {
        page.open("figure").leaf("div", "", "class", "pic " + style, "style", shape, "role", "img", "aria-label", name);
        page.leaf("figcaption", name).close();
    }

    private static void value(Markup page, EditResult edit, ValueResult value) {
        page.open("div", "class", "value");
        page.open("div");
        page.ready(LadderChart.svg("Error against time of " + edit.edit(), value.rungs().stream().map(EditPictures::point).toList(), 380,
                240));
        page.leaf("p", "RMSE against time, ms", "class", "axes").close();
        try (Table table = new Table(page, "tight", value.value(), "grade", "time", "saves", "values differ", "ulp", "largest", "RMSE",
                "PSNR", "SSIM", "ꟻLIP")) {
            value.rungs().forEach(rung -> row(table, rung));
        }
        page.close();
    }

    private static LadderChart.Point point(RungResult rung) {
        return new LadderChart.Point(rung.grade(), rung.time().lowerQuartile(), rung.time().median(), rung.time().upperQuartile(),
                rung.error().rmse());
    }

    private static void row(Table table, RungResult rung) {
        PictureError e = rung.error();
        table.row(rung.grade().label(), Numbers.ms(rung.time().median()), Numbers.percent(rung.saving()),
                Numbers.share(e.values(), e.of()), Numbers.grouped(e.maxUlp()), Numbers.error(e.maxAbsolute()),
                Numbers.error(e.rmse()), GradeSummary.decibels(e.displayPsnr()), GradeSummary.similarity(e.ssim()),
                Numbers.error(e.flip()));
    }
}
