package lightning.format.ies;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.DoubleBinaryOperator;

/** Generates the light profiles in {@code textures} from formulas. */
public final class ProfileMaker {
    private ProfileMaker() {}

    /**
     * Writes the profiles.
     *
     * @param args output folder
     */
    public static void main(String[] args) throws IOException {
        Files.writeString(Path.of(args[0], "downlight.ies"), downlight());
        Files.writeString(Path.of(args[0], "wall_washer.ies"), wallWasher());
    }

    /** Returns a reflector: a wide beam with a ring and an edge at 50 degrees. */
    static String downlight() {
        return file("a downlight", 5, 90, new int[] {0}, (v, _) -> {
            double edge = 1 / (1 + Math.exp((v - 42) / 4));
            return 1800 * edge * (0.55 + 0.45 * Math.pow(Math.cos(Math.toRadians(v * 3.2)), 2));
        });
    }

    /** Returns a profile with most light forward and out at 30 degrees, almost none backward. */
    static String wallWasher() {
        return file("a wall washer", 5, 90, new int[] {0, 30, 60, 90, 120, 150, 180}, (v, h) -> {
            double forward = Math.cos(Math.toRadians(h));
            double deviation = (v - 30 * Math.max(forward, 0)) / (18 + 14 * Math.max(forward, 0));
            return 900 * Math.exp(-deviation * deviation) * (0.6 + 0.4 * forward);
        });
    }

    private static String file(String title, int step, int last, int[] planes, DoubleBinaryOperator candela) {
        var text = new StringBuilder("IES:LM-63-2019\n[TEST] a formula\n[LUMINAIRE] " + title + "\nTILT=NONE\n");
        text.append("1 -1 1 ").append(last / step + 1).append(' ').append(planes.length).append(" 1 2 0.1 0.1 0\n1 1 10\n");
        for (int v = 0; v <= last; v += step) {
            text.append(v).append(v == last ? "\n" : " ");
        }
        for (int i = 0; i < planes.length; i++) {
            text.append(planes[i]).append(i == planes.length - 1 ? "\n" : " ");
        }
        for (int h : planes) {
            for (int v = 0; v <= last; v += step) {
                text.append(String.format(Locale.ROOT, "%.1f", candela.applyAsDouble(v, h))).append(v == last ? "\n" : " ");
            }
        }
        return text.toString();
    }
}
