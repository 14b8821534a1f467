package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import lightning.bench.result.EditResult;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.ValueResult;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import org.jspecify.annotations.Nullable;

/** Report section of single edits: images with a wipe comparison, accuracy settings, error against time. */
final class EditPictureSection {
    /** Image with its label. */
    private record LabeledPicture(String name, String style, @Nullable AccuracySetting setting) {}

    private EditPictureSection() {}

    static void write(HtmlWriter page, String id, SceneResult scene, EmbeddedPictures embedded) {
        for (int i = 0; i < scene.edits().size(); i++) {
            EditResult edit = scene.edits().get(i);
            if (!edit.values().isEmpty()) {
                page.open("details", "class", "edit", "id", id + "-edit-" + (i + 1), "open", i == 0 ? "open" : null);
                page.open("summary").element("b", edit.edit()).text(" " + headline(edit)).close();
                pictures(page, scene, edit.values().getFirst(), embedded);
                edit.values().forEach(value -> value(page, edit, value));
                page.close();
            }
        }
    }

    private static String headline(EditResult edit) {
        return (edit.figure().isEmpty() ? "" : edit.figure() + " · ") + "saves " + NumberText.percent(edit.saving())
                + (Double.isNaN(edit.paperSaving()) ? "" : ", the paper " + NumberText.percent(edit.paperSaving()));
    }

    private static void pictures(HtmlWriter page, SceneResult scene, ValueResult value, EmbeddedPictures embedded) {
        List<LabeledPicture> labeled = new ArrayList<>();
        List<LabeledPicture> differences = new ArrayList<>();
        add(labeled, "before", embedded.picture(scene.before()), null);
        for (SweepPointResult point : value.rungs()) {
            add(labeled, point.grade().label(), embedded.picture(point.picture()), point.grade());
            add(differences, point.grade().label(), embedded.difference(point.difference()), point.grade());
        }
        if (labeled.size() < 2) {
            return;
        }
        String aspectRatio = String.format(Locale.ROOT, "aspect-ratio:%d/%d", scene.width(), scene.height());
        int after = index(labeled, AccuracySetting.DEFAULT, index(labeled, AccuracySetting.EXACT, labeled.size() - 1));
        wipeControls(page, labeled, differences, after, aspectRatio);
        sideBySide(page, labeled, differences, after, aspectRatio);
    }

    private static void add(List<LabeledPicture> to, String name, @Nullable String style, @Nullable AccuracySetting setting) {
        if (style != null) {
            to.add(new LabeledPicture(name, style, setting));
        }
    }

    private static int index(List<LabeledPicture> pictures, @Nullable AccuracySetting setting, int defaultIndex) {
        for (int i = 0; i < pictures.size(); i++) {
            if (pictures.get(i).setting == setting) {
                return i;
            }
        }
        return defaultIndex;
    }

    /** Writes controls for the screen. */
    private static void wipeControls(HtmlWriter page, List<LabeledPicture> pictures, List<LabeledPicture> differences, int after,
            String aspectRatio) {
        page.open("div", "class", "wipe");
        page.open("div", "class", "view");
        page.open("div", "class", "stage", "style", aspectRatio);
        page.element("div", "", "class", "pic right " + pictures.get(after).style).element("div", "", "class",
                "pic left " + pictures.getFirst().style);
        page.emptyElement("input", "type", "range", "class", "cut", "min", "0", "max", "100", "value", "50", "step", "0.1", "aria-label",
                "wipe");
        page.close();
        page.open("div", "class", "controls");
        select(page, "left", pictures, 0);
        page.open("label").text("exposure ")
                .emptyElement("input", "type", "range", "class", "exposure", "min", "-6", "max", "6", "value", "0",
                        "step", "0.25")
                .element("output", "0 EV").close();
        select(page, "right", pictures, after);
        page.close().close();
        page.open("div", "class", "view");
        page.open("div", "class", "stage", "style", aspectRatio);
        page.element("p", "bit-identical", "class", "equal");
        int difference = index(differences, pictures.get(after).setting, -1);
        page.element("div", "", "class", "pic difference " + (difference < 0 ? "" : differences.get(difference).style));
        page.close();
        page.open("div", "class", "controls").open("label").text("difference from the full trace ");
        page.open("select", "class", "of", "aria-label", "accuracy setting of the difference");
        for (LabeledPicture s : pictures) {
            if (s.setting != null && s.setting != AccuracySetting.FULL_TRACE) {
                int i = index(differences, s.setting, -1);
                page.element("option", s.name, "value", i < 0 ? "" : differences.get(i).style, "selected",
                        s == pictures.get(after) ? "selected" : null);
            }
        }
        page.close().close();
        page.open("span", "class", "scale").element("i", "").text("2⁻²⁴ to 1").close().close().close().close();
    }

    private static void select(HtmlWriter page, String side, List<LabeledPicture> pictures, int selected) {
        page.open("select", "class", side, "aria-label", side + " picture");
        for (int i = 0; i < pictures.size(); i++) {
            page.element("option", pictures.get(i).name, "value", pictures.get(i).style, "selected", i == selected ? "selected" : null);
        }
        page.close();
    }

    /** Writes images side by side, for print and without scripts. */
    private static void sideBySide(HtmlWriter page, List<LabeledPicture> pictures, List<LabeledPicture> differences, int after,
            String aspectRatio) {
        page.open("div", "class", "side");
        picture(page, pictures.getFirst().name, pictures.getFirst().style, aspectRatio);
        picture(page, pictures.get(after).name, pictures.get(after).style, aspectRatio);
        int full = index(pictures, AccuracySetting.FULL_TRACE, -1);
        if (full >= 0 && full != after) {
            picture(page, pictures.get(full).name, pictures.get(full).style, aspectRatio);
        }
        int difference = index(differences, pictures.get(after).setting, -1);
        if (difference >= 0) {
            picture(page, "difference, false colors", differences.get(difference).style, aspectRatio);
        }
        page.close();
    }

    private static void picture(HtmlWriter page, String name, String style, String aspectRatio) {
        page.open("figure").element("div", "", "class", "pic " + style, "style", aspectRatio, "role", "img", "aria-label", name);
        page.element("figcaption", name).close();
    }

    private static void value(HtmlWriter page, EditResult edit, ValueResult value) {
        page.open("div", "class", "value");
        page.open("div");
        page.raw(AccuracyChart.svg("Error against time of " + edit.edit(), value.rungs().stream().map(EditPictureSection::point).toList(),
                380,
                240));
        page.element("p", "RMSE against time, ms", "class", "axes").close();
        try (HtmlTable table =
                new HtmlTable(page, "tight", value.value(), "setting", "time", "saves", "differing values", "max. ulp",
                        "max. difference", "RMSE",
                        "PSNR", "SSIM", "ꟻLIP")) {
            value.rungs().forEach(point -> row(table, point));
        }
        page.close();
    }

    private static AccuracyChart.Point point(SweepPointResult point) {
        return new AccuracyChart.Point(point.grade(), point.time().lowerQuartile(), point.time().median(), point.time().upperQuartile(),
                point.error().rmse());
    }

    private static void row(HtmlTable table, SweepPointResult point) {
        PictureError e = point.error();
        table.row(point.grade().label(), NumberText.ms(point.time().median()), NumberText.percent(point.saving()),
                NumberText.share(e.values(), e.of()), NumberText.grouped(e.maxUlp()), NumberText.error(e.maxAbsolute()),
                NumberText.error(e.rmse()), AccuracySummary.decibels(e.displayPsnr()), AccuracySummary.similarity(e.ssim()),
                NumberText.error(e.flip()));
    }
}
