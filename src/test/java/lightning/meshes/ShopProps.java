package lightning.meshes;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.math.Vec3;

/** Meshes of the shop window: a hat, a bottle with its content, and a cloth that is draped over a round plinth. */
final class ShopProps {
    /** Radius of the plinth below the cloth. */
    private static final double PLINTH = 0.5;

    private ShopProps() {}

    static Map<String, ParametricSurface> all() {
        var all = new LinkedHashMap<String, ParametricSurface>();
        all.put("hat", new ParametricSurface(72, 56, true, ShopProps::hat));
        all.put("flacon", new ParametricSurface(72, 56, true, flacon().revolve()));
        all.put("perfume", new ParametricSurface(72, 32, true, perfume().revolve()));
        all.put("drape", new ParametricSurface(120, 32, true, ShopProps::drape));
        return all;
    }

    /** Fedora: a crown of revolution with a dent along x, and a brim that is bent down in front and up at the sides. */
    private static Vec3 hat(double u, double v) {
        var profile = new LatheProfile(1, 0, 1.01, 0.012, 0.99, 0.025, 0.75, 0.03, 0.56, 0.04, 0.53, 0.09, 0.5, 0.3, 0.46, 0.55, 0.4,
                0.68, 0.26, 0.72, 0, 0.72);
        Vec3 p = profile.revolve().at(u, v);
        double r = Math.hypot(p.x(), p.z());
        double brim = Math.clamp((r - 0.56) / 0.45, 0, 1);
        double bend = brim * brim * (0.16 * p.z() * p.z() - 0.1 * p.x() * p.x());
        double crown = Math.clamp((p.y() - 0.3) / 0.4, 0, 1);
        double dent = 0.16 * crown * StrictMath.exp(-p.z() * p.z() / 0.018) * StrictMath.exp(-p.x() * p.x() / 0.16);
        double pinch = 1 - 0.16 * crown * StrictMath.exp(-(p.x() - 0.35) * (p.x() - 0.35) / 0.05);
        return new Vec3(1.12 * p.x(), p.y() + bend - dent, p.z() * pinch);
    }

    /** Profile up the outside, over the rim and down the inside. */
    private static LatheProfile flacon() {
        return new LatheProfile(0, 0, 0.3, 0, 0.36, 0.02, 0.5, 0.2, 0.56, 0.45, 0.5, 0.72, 0.3, 0.92, 0.14, 1, 0.12, 1.06, 0.12, 1.2, 0.15,
                1.24, 0.13, 1.26, 0.08, 1.24, 0.075, 1.06, 0.1, 0.98, 0.26, 0.87, 0.43, 0.7, 0.48, 0.45, 0.43, 0.23, 0.3, 0.11, 0, 0.1);
    }

    /** Content of the bottle, slightly smaller than its inside. */
    private static LatheProfile perfume() {
        return new LatheProfile(0, 0.108, 0.29, 0.118, 0.42, 0.235, 0.47, 0.45, 0.445, 0.6, 0.43, 0.62, 0, 0.62);
    }

    /** Round cloth, from its edge to its middle: lies flat on the plinth, hangs in folds around it and ends on the floor at y = 0. */
    private static Vec3 drape(double u, double v) {
        double angle = 2 * Math.PI * (u - Math.floor(u));
        double t = 1 - Math.clamp(v, 0, 1);
        double on = Math.min(1, t / 0.35);
        double below = Math.max(0, (t - 0.35) / 0.65);
        double folds = StrictMath.sin(11 * angle + 0.8 * StrictMath.sin(3 * angle)) + 0.35 * StrictMath.sin(23 * angle + 1);
        double open = StrictMath.pow(below, 1.3);
        double r = PLINTH * on + 0.1 * Math.sqrt(below) + 0.16 * open + 0.085 * StrictMath.sqrt(below) * (0.4 + 0.6 * below) * folds;
        double hem = 0.03 * open * StrictMath.cos(5 * angle);
        double y = 1 - 0.97 * StrictMath.pow(below, 1.12) + hem * below;
        return new Vec3(r * StrictMath.cos(angle), y, -r * StrictMath.sin(angle));
    }
}
