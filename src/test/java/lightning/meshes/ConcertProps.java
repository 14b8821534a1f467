package lightning.meshes;

import static lightning.meshes.Prism.withRoundedCorners;

import java.util.LinkedHashMap;
import java.util.Map;

/** Meshes of the concert: the body of a double bass and a cymbal. */
final class ConcertProps {
    private static final double BEVEL = 0.012;

    private ConcertProps() {}

    static Map<String, ParametricSurface> all() {
        var all = new LinkedHashMap<String, ParametricSurface>();
        all.put("bass_body", bassBody().mesh());
        all.put("cymbal", new ParametricSurface(64, 32, true, cymbal().revolve()));
        return all;
    }

    /** Lies on its back: from its foot at x = −0.5 to its neck at x = 0.5, with an arched belly. */
    private static Prism bassBody() {
        double[] outline = new Spline(true, -0.5, 0, -0.48, 0.16, -0.39, 0.28, -0.24, 0.31, -0.12, 0.25, -0.03, 0.175, 0.07, 0.165, 0.15,
                0.205, 0.25, 0.235, 0.34, 0.2, 0.42, 0.11, 0.49, 0.05, 0.5, 0, 0.49, -0.05, 0.42, -0.11, 0.34, -0.2, 0.25, -0.235, 0.15,
                -0.205, 0.07, -0.165, -0.03, -0.175, -0.12, -0.25, -0.24, -0.31, -0.39, -0.28, -0.48, -0.16).sampled(144);
        double[] profile = {0, 0, 1, 0, 1, 0.15, 0.94, 0.155, 0.75, 0.175, 0.4, 0.19, 0, 0.195};
        return new Prism(outline, withRoundedCorners(profile, BEVEL, false), 0, 0);
    }

    /** One unit in radius, thin at its edge, with a bell in its middle. */
    private static LatheProfile cymbal() {
        return new LatheProfile(0, 0.1, 0.12, 0.09, 0.22, 0.02, 0.3, 0, 0.7, -0.05, 0.99, -0.11, 1, -0.105, 0.99, -0.1, 0.7, -0.035, 0.3,
                0.02, 0.22, 0.04, 0.12, 0.11, 0, 0.12);
    }
}
