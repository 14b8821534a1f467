package lightning.bench.report;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import lightning.render.measure.AccuracySetting;
import lightning.render.relight.paper.Accuracy;

/**
 * Colors of charts. In the page each is a variable of the style sheet, such as {@code --paper}, which depends on the theme; {@link #color}
 * is used only for drawing. Hues are from Okabe and Ito, "Color Universal Design", 2008, distinguishable without color vision.
 */
enum PlotColor {
    TEXT(0x1A1D21),
    MUTED(0x5F6770),
    GRID(0xDFE3E8),
    PAPER(0xA3ABB5),
    OURS(0x0072B2),
    SKY(0x56B4E9),
    GREEN(0x009E73),
    ORANGE(0xE69F00),
    RED(0xD55E00),
    PURPLE(0xB8609A);

    private static final Map<Integer, PlotColor> BY_COLOR =
            Arrays.stream(values()).collect(Collectors.toMap(ink -> ink.color.getRGB() & 0xFFFFFF, ink -> ink));

    /** Colors in the order of the accuracy settings. */
    private static final List<PlotColor> BY_SETTING = List.of(ORANGE, RED, MUTED, MUTED, PURPLE, SKY, GREEN, OURS, TEXT);

    private final Color color;

    PlotColor(int rgb) {
        color = new Color(rgb);
    }

    Color color() {
        return color;
    }

    /** Returns the style sheet expression: {@code var(--ours)}. */
    String variable() {
        return "var(--" + name().toLowerCase(Locale.ROOT) + ")";
    }

    /** Returns the style sheet expression of a chart color; the color itself if it is none of these. */
    static String variable(int red, int green, int blue) {
        PlotColor plotColor = BY_COLOR.get(red << 16 | green << 8 | blue);
        return plotColor == null ? String.format(Locale.ROOT, "rgb(%d,%d,%d)", red, green, blue) : plotColor.variable();
    }

    static PlotColor of(AccuracySetting setting) {
        return BY_SETTING.get(setting.ordinal());
    }

    static PlotColor of(Accuracy accuracy) {
        return accuracy.isExact() ? OURS : PURPLE;
    }

    /** Returns the color of a line without a meaning of its own. */
    static PlotColor of(int line) {
        PlotColor[] colors = {OURS, RED, GREEN, PURPLE, ORANGE, SKY, TEXT, MUTED};
        return colors[line % colors.length];
    }
}
