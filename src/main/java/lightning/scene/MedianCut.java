package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;

/**
 * Cuts a sky into parts of about the same light, each of which becomes a lamp at its middle (Debevec, A Median Cut Algorithm for Light Probe
 * Sampling, 2005). There all parts are cut at once; here always the brightest, so that any number of parts can be had. A part is cut across its longer side,
 * where both halves have light as alike as can be; light is luminance over solid angle. Large pictures are summed in cells of some pixels first.
 */
final class MedianCut {
    private static final int CELLS_ACROSS = 256;
    private static final int CELLS_DOWN = 128;

    private final int across;
    private final int down;
    /** Red, green, blue over solid angle, and luminance, of each cell. */
    private final double[][] light;
    /** Sums of luminance over all cells to the left and above. */
    private final double[] sums;

    private record Part(int left, int top, int right, int bottom, double light) {
        boolean isOne() {
            return right - left == 1 && bottom - top == 1;
        }
    }

    MedianCut(Sky sky) {
        across = Math.min(sky.width(), CELLS_ACROSS);
        down = Math.min(sky.height(), CELLS_DOWN);
        light = new double[4][across * down];
        for (int y = 0; y < sky.height(); y++) {
            double angle = sky.solidAngle(y);
            int line = (int) ((long) y * down / sky.height()) * across;
            for (int x = 0; x < sky.width(); x++) {
                int cell = line + (int) ((long) x * across / sky.width());
                for (int c = 0; c < 3; c++) {
                    light[c][cell] += sky.channel(x, y, c) * angle;
                }
            }
        }
        sums = new double[(across + 1) * (down + 1)];
        for (int i = 0; i < across * down; i++) {
            light[3][i] = 0.2126 * light[0][i] + 0.7152 * light[1][i] + 0.0722 * light[2][i];
            int at = (i / across + 1) * (across + 1) + i % across + 1;
            sums[at] = light[3][i] + sums[at - 1] + sums[at - across - 1] - sums[at - across - 2];
        }
    }

    /** At most so many lamps, fewer where there are not as many cells with light. */
    List<SkyLamp> lamps(int most) {
        List<Part> parts = new ArrayList<>(List.of(part(0, 0, across, down)));
        while (parts.size() < most) {
            int brightest = -1;
            for (int i = 0; i < parts.size(); i++) {
                boolean better = brightest < 0 || parts.get(i).light > parts.get(brightest).light;
                brightest = better && !parts.get(i).isOne() && parts.get(i).light > 0 ? i : brightest;
            }
            if (brightest < 0) {
                break;
            }
            cut(parts, brightest);
        }
        return parts.stream().map(this::lamp).toList();
    }

    private Part part(int left, int top, int right, int bottom) {
        int w = across + 1;
        return new Part(left, top, right, bottom,
                sums[bottom * w + right] - sums[bottom * w + left] - sums[top * w + right] + sums[top * w + left]);
    }

    private void cut(List<Part> parts, int which) {
        Part p = parts.get(which);
        double wide = (p.right - p.left) * 2.0 / across * StrictMath.sin(Math.PI * (p.top + p.bottom) / 2 / down);
        boolean upright = p.bottom - p.top == 1 || p.right - p.left > 1 && wide >= (double) (p.bottom - p.top) / down;
        Part first = null;
        Part second = null;
        for (int at = upright ? p.left + 1 : p.top + 1; at < (upright ? p.right : p.bottom); at++) {
            Part a = upright ? part(p.left, p.top, at, p.bottom) : part(p.left, p.top, p.right, at);
            Part b = upright ? part(at, p.top, p.right, p.bottom) : part(p.left, at, p.right, p.bottom);
            if (first == null || Math.abs(a.light - b.light) < Math.abs(first.light - second.light)) {
                first = a;
                second = b;
            }
        }
        parts.set(which, first);
        parts.add(second);
    }

    /** Where the middle of a part's light is; of a dark part, of its cells. */
    private SkyLamp lamp(Part p) {
        double[] sum = new double[3];
        Vec3 towards = Vec3.ZERO;
        Vec3 middle = Vec3.ZERO;
        double all = 0;
        double spared = 0;
        for (int y = p.top; y < p.bottom; y++) {
            double polar = Math.PI * (y + 0.5) / down;
            double angle = 2 * Math.PI / across * (StrictMath.cos(Math.PI * y / down) - StrictMath.cos(Math.PI * (y + 1) / down));
            for (int x = p.left; x < p.right; x++) {
                double around = 2 * Math.PI * ((x + 0.5) / across - 0.5);
                Vec3 cell = new Vec3(StrictMath.sin(polar) * StrictMath.sin(around), StrictMath.cos(polar),
                        -StrictMath.sin(polar) * StrictMath.cos(around));
                middle = middle.plus(cell);
                towards = towards.plus(cell.times(light[3][y * across + x]));
                all += light[3][y * across + x];
                spared += light[3][y * across + x] * angle / (4 * Math.PI);
                for (int c = 0; c < 3; c++) {
                    sum[c] += light[c][y * across + x];
                }
            }
        }
        return new SkyLamp(direction(towards, middle), all > 0 ? spread(towards.length() / all * (1 - spared / all)) : 0, sum[0] / Math.PI,
                sum[1] / Math.PI, sum[2] / Math.PI);
    }

    /**
     * The even cap of half angle a has a mean direction as long as (1 + cos a) / 2, its integral of cosines over its solid angle; so a cell, whose
     * solid angle is 2π(1 − cos a), shortens it by a share of that over 4π.
     *
     * @param length of the mean direction, 0 … 1
     */
    private static double spread(double length) {
        return Math.toDegrees(StrictMath.acos(Math.clamp(2 * length - 1, 0, 1)));
    }

    private static Vec3 direction(Vec3 towards, Vec3 middle) {
        return towards.length() > 1e-30 ? towards.normalized() : middle.length() > 1e-6 ? middle.normalized() : Vec3.Y;
    }
}
