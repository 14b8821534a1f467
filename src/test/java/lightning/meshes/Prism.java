package lightning.meshes;

import lightning.base.math.Vec3;
import lightning.meshes.ParametricSurface.SurfaceFunction;

/**
 * Upright body with the same outline at each height, around a center line. Points next to a corner keep the faces flat and the corner
 * rounded.
 *
 * @param outline points of the outline, seen from above: x, z, x, z …; a straight line of the center meets it once in each direction
 * @param profile share of the way from the center to the outline, height, share, height …; from the bottom to the top
 * @param centerX x of the center line
 * @param centerZ z of the center line
 */
record Prism(double[] outline, double[] profile, double centerX, double centerZ) {
    /** Returns the number of points of the outline. */
    int across() {
        return outline.length / 2;
    }

    /** Returns the number of steps of the profile. */
    int rows() {
        return profile.length / 2 - 1;
    }

    ParametricSurface mesh() {
        return new ParametricSurface(across(), rows(), true, form());
    }

    private SurfaceFunction form() {
        return (u, v) -> {
            double along = (u - Math.floor(u)) * across();
            int side = Math.min((int) along, across() - 1);
            int next = (side + 1) % across();
            double t = along - side;
            double up = Math.clamp(v, 0, 1) * rows();
            int row = Math.min((int) up, rows() - 1);
            double s = up - row;
            double share = mix(profile[2 * row], profile[2 * row + 2], s);
            double x = mix(outline[2 * side], outline[2 * next], t);
            double z = mix(outline[2 * side + 1], outline[2 * next + 1], t);
            return new Vec3(mix(centerX, x, share), mix(profile[2 * row + 1], profile[2 * row + 3], s), mix(centerZ, z, share));
        };
    }

    private static double mix(double a, double b, double t) {
        return a + t * (b - a);
    }

    /**
     * Returns a line through points with a point on each side of each corner.
     *
     * @param points two coordinates of each point
     * @param bevel  distance of the added points from the corner
     * @param closed true if the last point continues to the first
     */
    static double[] withRoundedCorners(double[] points, double bevel, boolean closed) {
        int n = points.length / 2;
        double[] all = new double[6 * n - (closed ? 0 : 8)];
        int at = 0;
        for (int i = 0; i < n; i++) {
            if (!closed && (i == 0 || i == n - 1)) {
                all[at++] = points[2 * i];
                all[at++] = points[2 * i + 1];
                continue;
            }
            at = put(all, at, points, i, (i + n - 1) % n, bevel);
            at = put(all, at, points, i, i, 0);
            at = put(all, at, points, i, (i + 1) % n, bevel);
        }
        return all;
    }

    /** Puts the point at {@code distance} from point i toward point j. */
    private static int put(double[] all, int at, double[] points, int i, int j, double distance) {
        double dx = points[2 * j] - points[2 * i];
        double dy = points[2 * j + 1] - points[2 * i + 1];
        double share = distance == 0 ? 0 : distance / Math.hypot(dx, dy);
        all[at] = points[2 * i] + share * dx;
        all[at + 1] = points[2 * i + 1] + share * dy;
        return at + 2;
    }
}
