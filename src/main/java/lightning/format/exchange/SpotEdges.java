package lightning.format.exchange;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;
import lightning.base.text.DecimalNumber;
import lightning.format.exchange.assembly.ConeProfile;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.asset.IesProfile;
import lightning.scene.light.Light;
import lightning.scene.value.Photometry;

/**
 * Soft edges of spots as glTF defines them (KHR_lights_punctual), as light profiles: full light up to the inner angle, then the square of
 * (cos a − cos outer) / (cos inner − cos outer) at the angle a.
 */
final class SpotEdges {
    private static final Pattern NAME = Pattern.compile("spot [0-9.E-]+ inner ([0-9.E-]+)\\.ies");

    private final Map<String, IesProfile> profiles = new HashMap<>();

    /**
     * Returns a profile, shared by equal spots; empty if the scene would have too many.
     *
     * @param inner degrees, from 0 to below {@code outer}
     * @param outer degrees, at most 90
     */
    Optional<IesProfile> profile(double inner, double outer) {
        // Angles in radians have no short names in degrees.
        double shortInner = rounded(inner) < outer ? rounded(inner) : inner;
        Photometry edge = edge(shortInner, outer).photometry();
        String name = name(shortInner, rounded(outer));
        IesProfile known = profiles.get(name);
        if (known != null && !known.photometry().equals(edge)) {
            name = name(shortInner, outer);
            known = profiles.get(name);
        }
        if (known == null && profiles.size() >= JenLimits.PROFILES) {
            return Optional.empty();
        }
        return Optional.of(profiles.computeIfAbsent(name, n -> new IesProfile(n, edge)));
    }

    private static String name(double inner, double outer) {
        return "spot " + DecimalNumber.format(outer) + " inner " + DecimalNumber.format(inner) + ".ies";
    }

    private static double rounded(double degrees) {
        return Math.rint(1e3 * degrees) / 1e3;
    }

    /** Adds the files of the profiles that lights have. */
    void addFiles(SceneAssembler assembler) {
        Set<String> added = new HashSet<>();
        for (Light light : assembler.lights) {
            OptionalDouble inner = inner(light);
            if (inner.isPresent() && added.add(light.profile().orElseThrow().file())) {
                assembler.addFile(light.profile().orElseThrow().file(), edge(inner.getAsDouble(), light.angle()).file());
            }
        }
    }

    private static ConeProfile edge(double inner, double outer) {
        double cosInner = Math.cos(Math.toRadians(inner));
        double cosOuter = Math.cos(Math.toRadians(outer));
        return new ConeProfile("edge of a spot in glTF", inner, outer, t -> {
            double share = (Math.cos(Math.toRadians(inner + t * (outer - inner))) - cosOuter) / (cosInner - cosOuter);
            return Math.clamp(share * share, 0, 1);
        });
    }

    /** Returns the inner angle, in degrees, of a light whose profile was made here for its angle; empty for any other. */
    static OptionalDouble inner(Light light) {
        return ConeProfile.parameter(light, NAME, inner -> inner >= 0 && inner < light.angle() && light.angle() <= 90,
                inner -> edge(inner, light.angle()));
    }
}
