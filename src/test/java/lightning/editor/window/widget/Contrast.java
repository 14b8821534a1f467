package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.layout.BackgroundFill;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.paint.LinearGradient;
import javafx.scene.paint.Paint;
import javafx.scene.paint.Stop;
import javafx.scene.text.Text;
import org.kordamp.ikonli.javafx.FontIcon;

/** Contrast ratio of texts and icons against their background (WCAG 2.2, success criteria 1.4.3 and 1.4.11). */
public final class Contrast {
    /** Minimum ratio of text. */
    public static final double MIN_TEXT_RATIO = 4.5;
    /** Minimum ratio of icons and focus marks. */
    public static final double MIN_ICON_RATIO = 3;
    /** Background color of a dark or light window. */
    private static final Color DEFAULT_BACKGROUND = Color.GRAY;

    private Contrast() {}

    /** Returns the contrast ratio (L1 + 0.05) / (L2 + 0.05), 1…21, of relative luminances L1 ≥ L2 (WCAG 2.2, "contrast ratio"). */
    public static double ratio(Color a, Color b) {
        double la = luminance(a);
        double lb = luminance(b);
        return (Math.max(la, lb) + 0.05) / (Math.min(la, lb) + 0.05);
    }

    /** Returns the relative luminance (WCAG 2.2, "relative luminance"). */
    private static double luminance(Color c) {
        return 0.2126 * linear(c.getRed()) + 0.7152 * linear(c.getGreen()) + 0.0722 * linear(c.getBlue());
    }

    private static double linear(double v) {
        return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
    }

    /** Returns visible, enabled texts and icons below a node with too little contrast, one line each. */
    public static List<String> findLowContrast(Node root) {
        List<String> found = new ArrayList<>();
        checkNode(root, found);
        return found.stream().distinct().toList();
    }

    private static void checkNode(Node node, List<String> found) {
        // Disabled items are exempt (WCAG 2.2, 1.4.3, "incidental").
        if (!node.isVisible() || node.isDisabled()) {
            return;
        }
        if (node instanceof Text text && !text.getText().isBlank() && text.getFill() instanceof Color fill) {
            double required = text instanceof FontIcon ? MIN_ICON_RATIO : MIN_TEXT_RATIO;
            double opacity = opacity(text);
            backgrounds(text.getParent()).stream().min(Comparator.comparingDouble(b -> ratio(blend(fill, opacity, b), b))).ifPresent(b -> {
                double ratio = ratio(blend(fill, opacity, b), b);
                if (ratio < required) {
                    found.add(String.format(Locale.ROOT, "%.2f: %s on %s, %s in %s", ratio, blend(fill, opacity, b), b,
                            text instanceof FontIcon icon ? String.valueOf(icon.getIconCode()) : "\"" + text.getText() + "\"",
                            describe(text)));
                }
            });
        }
        if (node instanceof Parent parent) {
            parent.getChildrenUnmodifiable().forEach(child -> checkNode(child, found));
        }
    }

    private static String describe(Node node) {
        StringBuilder path = new StringBuilder();
        for (Node n = node.getParent(); n != null && path.length() < 160; n = n.getParent()) {
            path.append(" < ").append(n.getId() == null ? n.getStyleClass() : "#" + n.getId());
        }
        return path.toString();
    }

    private static double opacity(Node node) {
        double opacity = 1;
        for (Node n = node; n != null; n = n.getParent()) {
            opacity *= n.getOpacity();
        }
        return opacity;
    }

    /** Returns the background colors of a node: each stop of a gradient. */
    private static List<Color> backgrounds(Node node) {
        if (node == null) {
            return List.of(DEFAULT_BACKGROUND);
        }
        List<Color> below = backgrounds(node.getParent());
        if (node instanceof Region region && region.getBackground() != null) {
            for (BackgroundFill fill : region.getBackground().getFills()) {
                List<Color> under = below;
                below = colors(fill.getFill()).flatMap(c -> under.stream().map(b -> blend(c, 1, b))).distinct().toList();
            }
        }
        return below;
    }

    private static Stream<Color> colors(Paint paint) {
        return switch (paint) {
            case Color c -> Stream.of(c);
            case LinearGradient g -> g.getStops().stream().map(Stop::getColor);
            default -> Stream.of(Color.TRANSPARENT);
        };
    }

    private static Color blend(Color top, double opacity, Color below) {
        double a = top.getOpacity() * opacity;
        return Color.color(a * top.getRed() + (1 - a) * below.getRed(), a * top.getGreen() + (1 - a) * below.getGreen(),
                a * top.getBlue() + (1 - a) * below.getBlue());
    }
}
