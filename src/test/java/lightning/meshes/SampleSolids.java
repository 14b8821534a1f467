package lightning.meshes;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.math.Vec3;

/** Sample solids by file name. */
final class SampleSolids {
    private SampleSolids() {}

    static Map<String, ParametricSurface> all() {
        var all = new LinkedHashMap<String, ParametricSurface>();
        all.put("vase", new ParametricSurface(96, 80, true, vase().revolve()));
        all.put("twist", new ParametricSurface(144, 72, true, twist().fluted(7, 0.09, 0.22)));
        all.put("bowl", new ParametricSurface(96, 48, true, bowl().revolve()));
        all.put("pear", new ParametricSurface(48, 48, true, SampleSolids::pear));
        all.put("candlestick", new ParametricSurface(64, 96, true, candlestick().revolve()));
        all.put("shell", new ParametricSurface(40, 240, true, SampleSolids::shell));
        all.put("knot", new ParametricSurface(32, 480, true, SampleSolids::knot));
        all.put("column", new ParametricSurface(192, 64, true, column().fluted(24, 0.03, 0)));
        all.put("fir", new ParametricSurface(44, 72, true, SampleSolids::fir));
        all.put("goblet", new ParametricSurface(96, 120, true, goblet().revolve()));
        all.put("decanter", new ParametricSurface(96, 120, true, decanter().revolve()));
        all.put("cognac", new ParametricSurface(96, 60, true, cognac().revolve()));
        all.putAll(StageProps.all());
        all.putAll(ConcertProps.all());
        all.putAll(ShopProps.all());
        all.put("land", new ParametricSurface(150, 150, false, Terrain::at));
        return all;
    }

    /** Profile up the outside, over the rim and down the inside. */
    private static LatheProfile vase() {
        return new LatheProfile(0, 0, 0.34, 0, 0.36, 0.03, 0.3, 0.1, 0.46, 0.45, 0.58, 0.9, 0.5, 1.35, 0.25, 1.7, 0.2, 1.95, 0.3, 2.15,
                0.31,
                2.17, 0.29, 2.16, 0.18, 1.95, 0.22, 1.7, 0.46, 1.35, 0.54, 0.9, 0.3, 0.3, 0, 0.2);
    }

    private static LatheProfile twist() {
        return new LatheProfile(0, 0, 0.3, 0, 0.34, 0.04, 0.42, 0.35, 0.38, 0.75, 0.24, 1.05, 0.26, 1.3, 0.36, 1.5, 0.345, 1.51, 0.24, 1.3,
                0.21, 1.05, 0.3, 0.6, 0, 0.3);
    }

    private static LatheProfile bowl() {
        return new LatheProfile(0, 0, 0.38, 0, 0.4, 0.05, 0.36, 0.1, 0.7, 0.3, 0.98, 0.62, 1, 0.64, 0.97, 0.63, 0.66, 0.34, 0.3, 0.17, 0,
                0.15);
    }

    private static LatheProfile goblet() {
        return new LatheProfile(0, 0, 0.44, 0, 0.47, 0.015, 0.4, 0.04, 0.12, 0.075, 0.055, 0.14, 0.04, 0.45, 0.05, 0.8, 0.14, 0.9, 0.36,
                1.08,
                0.47, 1.36, 0.45, 1.68, 0.39, 2, 0.38, 2.01, 0.37, 2, 0.425, 1.68, 0.445, 1.36, 0.335, 1.12, 0.12, 0.96, 0, 0.94);
    }

    private static LatheProfile decanter() {
        return new LatheProfile(0, 0, 0.5, 0, 0.6, 0.05, 0.66, 0.3, 0.62, 0.75, 0.45, 1.1, 0.22, 1.35, 0.16, 1.55, 0.15, 1.85, 0.22, 2.02,
                0.23,
                2.05, 0.2, 2.05, 0.11, 1.85, 0.11, 1.55, 0.17, 1.35, 0.4, 1.06, 0.56, 0.73, 0.6, 0.3, 0.52, 0.15, 0.3, 0.12, 0, 0.12);
    }

    /** Content of the decanter, slightly smaller than its inside. */
    private static LatheProfile cognac() {
        return new LatheProfile(0, 0.125, 0.3, 0.125, 0.515, 0.155, 0.595, 0.3, 0.555, 0.73, 0.535, 0.78, 0, 0.78);
    }

    private static LatheProfile candlestick() {
        return new LatheProfile(0, 0, 0.42, 0, 0.44, 0.05, 0.36, 0.1, 0.15, 0.16, 0.1, 0.25, 0.19, 0.34, 0.2, 0.4, 0.1, 0.48, 0.075, 0.7,
                0.1,
                0.95, 0.16, 1.05, 0.1, 1.15, 0.11, 1.2, 0.22, 1.27, 0.23, 1.3, 0.12, 1.29, 0.11, 1.25, 0, 1.24);
    }

    /** Shaft with a base and a capital, four units high. */
    private static LatheProfile column() {
        return new LatheProfile(0, 0, 0.5, 0, 0.52, 0.08, 0.46, 0.16, 0.48, 0.22, 0.4, 0.28, 0.37, 0.4, 0.375, 1.4, 0.36, 2.4, 0.32, 3.4,
                0.33,
                3.5, 0.31, 3.54, 0.33, 3.6, 0.48, 3.8, 0.5, 3.86, 0.5, 4, 0, 4);
    }

    /** Pear that leans slightly, and bulges more to one side. */
    private static Vec3 pear(double u, double v) {
        double round = Math.PI * Math.clamp(v, 0, 1);
        double r = 0.42 * StrictMath.sin(round) * (1 + 0.32 * StrictMath.cos(round) + 0.1 * StrictMath.cos(3 * round));
        double y = 0.5 - 0.55 * StrictMath.cos(round) - 0.06 * StrictMath.exp(-6 * round);
        double angle = 2 * Math.PI * (u - Math.floor(u));
        double bulge = 1 + 0.05 * StrictMath.cos(angle + 1) * StrictMath.sin(round);
        return new Vec3(r * bulge * StrictMath.cos(angle) + 0.08 * y * y, y, -r * bulge * StrictMath.sin(angle));
    }

    /** Snail shell: a growing ring that climbs as it turns. */
    private static Vec3 shell(double u, double v) {
        double size = StrictMath.exp(3.4 * (v - 1));
        double round = 2 * Math.PI * 4.2 * v;
        double angle = 2 * Math.PI * (u - Math.floor(u));
        double ridge = 1 + 0.03 * StrictMath.cos(30 * Math.PI * v * 4.2 / 2);
        double r = size * (0.5 + 0.42 * ridge * StrictMath.cos(angle));
        double y = 2.1 * (1 - size) + size * (0.5 + 0.52 * ridge * StrictMath.sin(angle));
        return new Vec3(r * StrictMath.cos(round), y, -r * StrictMath.sin(round));
    }

    /** Trefoil knot on its torus, as a tube. */
    private static Vec3 knot(double u, double v) {
        double t = 2 * Math.PI * (v - Math.floor(v));
        Vec3 centre = trefoil(t);
        Vec3 tangent = trefoil(t + 1e-4).minus(trefoil(t - 1e-4)).normalized();
        Vec3 aside = tangent.cross(new Vec3(StrictMath.cos(2 * t), 0, -StrictMath.sin(2 * t))).normalized();
        Vec3 out = aside.cross(tangent);
        double angle = 2 * Math.PI * (u - Math.floor(u));
        return centre.plus(out.times(0.24 * StrictMath.cos(angle))).plus(aside.times(-0.24 * StrictMath.sin(angle)));
    }

    private static Vec3 trefoil(double t) {
        double r = 1 + 0.45 * StrictMath.cos(3 * t);
        return new Vec3(r * StrictMath.cos(2 * t), 0.45 * StrictMath.sin(3 * t), -r * StrictMath.sin(2 * t));
    }

    /** Fir with whorls of hanging boughs, one unit high; its trunk is hidden. */
    private static Vec3 fir(double u, double v) {
        double angle = 2 * Math.PI * (u - Math.floor(u));
        double whorls = 9 * v;
        double whorl = whorls - Math.floor(whorls);
        double boughs = 1 + 0.22 * StrictMath.cos(11 * angle + 2.4 * Math.floor(whorls));
        double r = 0.3 * (1 - 0.96 * v) * (1 - 0.55 * whorl) * boughs;
        double y = 0.04 + 0.96 * v - 0.05 * (1 - whorl) * (1 - v);
        return new Vec3(r * StrictMath.cos(angle), y, -r * StrictMath.sin(angle));
    }
}
