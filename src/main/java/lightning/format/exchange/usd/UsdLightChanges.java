package lightning.format.exchange.usd;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.usd.UsdLayer;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Emission;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.shot.Shot;

/**
 * Attributes of UsdLux that an imported light needs in a layer over its stage: those that depend on an attribute of the light that has been
 * edited since the import.
 */
public final class UsdLightChanges {
    private static final Set<String> PLACE = Set.of("at", "direction", "up", "profile", "type");
    private static final Set<String> SIZE = Set.of("radius", "spread", "width", "height", "type");
    /** Names of the light's attributes on which each attribute of UsdLux depends; on {@link #SIZE} if it is not listed. */
    private static final Map<String, Set<String>> SOURCES = Map.ofEntries(
            Map.entry("color3f inputs:color", Set.of("color", "temperature")),
            Map.entry("float inputs:exposure", Set.of("exposure")),
            Map.entry("bool inputs:enableColorTemperature", Set.of("temperature")),
            Map.entry("float inputs:colorTemperature", Set.of("temperature")),
            Map.entry("float inputs:diffuse", Set.of("diffuse")),
            Map.entry("float inputs:specular", Set.of("specular")),
            Map.entry("bool inputs:shadow:enable", Set.of("casts_shadows")),
            Map.entry(UsdLightValues.ANGLE, Set.of("angle", "cone", "profile", "type")),
            Map.entry(UsdLightValues.SOFTNESS, Set.of("angle", "cone_softness", "profile", "type")),
            Map.entry(UsdLightValues.FOCUS, Set.of("dropoff", "type")),
            Map.entry(UsdLightValues.VISIBILITY, Set.of("on")),
            Map.entry(UsdLightValues.MATRIX, PLACE));
    /** Attributes that an animated size leaves as they are. */
    private static final Set<String> NOT_ANIMATED = Set.of(UsdLightValues.NORMALIZE, UsdLightValues.POINT);
    private static final Set<String> POWER = Set.of("intensity", "unit", "exposure", "attenuation", "falloff");

    /**
     * The light at a time.
     *
     * @param light with color and intensity of its group
     * @param isOn  whether it shines, with all switches
     */
    public record State(int time, Light light, boolean isOn, double meters) {}

    private final UsdOriginal original;
    private final Light before;
    private final String originalType;
    private final String type;
    private final List<State> states;
    private final boolean hasZUp;
    private final Set<String> edited;
    private final Vec3 scale;
    private final boolean isNormalized;
    private final Map<String, TreeMap<Integer, String>> values;

    /**
     * @param light  the light itself, without its group
     * @param type   type of the prim now
     * @param states the light at all frames; at one only if nothing moves
     * @param paths  of the scene
     */
    public UsdLightChanges(UsdOriginal original, Light light, Optional<Shot> shot, String originalType, String type, List<State> states,
            UsdPaths paths) {
        this.original = original;
        this.originalType = originalType;
        this.type = type;
        this.states = states;
        hasZUp = paths.hasZUp();
        scale = LightScales.of(original.world());
        edited = edited(light, shot, paths);
        before = edited.contains("profile") ? original.light() : original.light().withProfile(light.profile());
        isNormalized = original.isNormalized() || states.stream().anyMatch(s -> !Double.isFinite(intensity(s.light(), false, s.meters())));
        values = changedValues();
    }

    /** Returns the values of attributes at all states, by declaration and time. */
    public static Map<String, TreeMap<Integer, String>> series(List<State> states, Function<State, Map<String, String>> valuesAt) {
        Map<String, TreeMap<Integer, String>> result = new LinkedHashMap<>();
        for (State state : states) {
            valuesAt.apply(state).forEach((declaration, value) -> result.computeIfAbsent(declaration, _ -> new TreeMap<>())
                    .put(state.time(), value));
        }
        return result;
    }

    private Set<String> edited(Light light, Optional<Shot> shot, UsdPaths paths) {
        Set<String> result = new HashSet<>();
        Map<String, String> tracks = UsdOriginal.hashes(light.name(), shot);
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (!isSame(attribute, light, paths)
                    || !Objects.equals(tracks.get(attribute.name()), original.tracks().get(attribute.name()))) {
                result.add(attribute.name());
            }
        }
        if (!light.lightGroup().isEmpty()) {
            result.addAll(List.of("color", "intensity"));
        }
        if (states.stream().anyMatch(s -> s.isOn() != s.light().on())) {
            result.add("on");
        }
        return result;
    }

    private <V> boolean isSame(SceneAttribute<Light, V> attribute, Light light, UsdPaths paths) {
        Optional<String> file = attribute.file(original.light());
        Optional<String> own = attribute.file(light);
        return file.isPresent() || own.isPresent() ? file.isPresent() && own.isPresent() && paths.isSameFile(file.get(), own.get())
                : attribute.get(original.light()).equals(attribute.get(light));
    }

    /** Returns whether an attribute of the light has been edited. */
    public boolean has(LightAttribute<?> attribute) {
        return edited.contains(attribute.name());
    }

    /** Returns the light as it was imported, with the files of the scene where these are the same. */
    public Light before() {
        return before;
    }

    /** Returns whether the prim gets another type. */
    public boolean isRetyped() {
        return !type.equals(originalType);
    }

    /** Returns whether the transform is that in the stage, since it cannot be one under the parent. */
    public boolean leavesRig() {
        return values.containsKey(UsdLightValues.MATRIX) && !isInRig();
    }

    /** Returns the values of each attribute that changes, by its declaration and time. */
    public Map<String, TreeMap<Integer, String>> values() {
        return values;
    }

    private Map<String, TreeMap<Integer, String>> changedValues() {
        Map<String, TreeMap<Integer, String>> now = series(states, state -> values(state, type, isNormalized));
        Map<String, String> old = values(new State(0, before, before.on(), states.getFirst().meters()), originalType,
                original.isNormalized());
        // Where the import could not keep these, the light says something else than the stage.
        old.computeIfPresent(UsdLightValues.SOFTNESS, (_, _) -> UsdLayer.number(original.softness()));
        old.computeIfPresent(UsdLightValues.POINT, (_, _) -> original.isTreatedAsPoint() ? "1" : "0");
        Map<String, TreeMap<Integer, String>> result = new LinkedHashMap<>();
        now.forEach((declaration, samples) -> {
            if (isChanged(declaration, samples, Optional.ofNullable(old.get(declaration)))) {
                result.put(declaration, samples);
            }
        });
        return result;
    }

    private boolean isChanged(String declaration, TreeMap<Integer, String> samples, Optional<String> old) {
        Set<String> sources = sources(declaration);
        if (sources.stream().noneMatch(edited::contains)) {
            return false;
        }
        boolean isTracked = !NOT_ANIMATED.contains(declaration) && sources.stream().anyMatch(original.tracks()::containsKey);
        boolean isSteady = samples.values().stream().distinct().count() == 1 && !isTracked;
        return !isSteady || old.isEmpty() || !old.get().equals(samples.firstEntry().getValue());
    }

    private Set<String> sources(String declaration) {
        if (!declaration.equals(UsdLightValues.INTENSITY)) {
            return SOURCES.getOrDefault(declaration, SIZE);
        }
        // A luminance does not depend on the size, nor does a power on it.
        boolean isDirect = !isRetyped() && isNormalized == original.isNormalized()
                && Stream.concat(Stream.of(before), states.stream().map(State::light))
                        .allMatch(l -> switch (l.emission().unit()) {
                            case NIT -> !isNormalized;
                            case CANDELA, LUX, RELATIVE -> isNormalized;
                            case LUMEN -> false;
                        });
        Set<String> all = new HashSet<>(POWER);
        if (!isDirect) {
            all.addAll(SIZE);
            all.addAll(Set.of("angle", "dropoff", "cone", "cone_softness", "beam_spread"));
        }
        return all;
    }

    private Map<String, String> values(State state, String prim, boolean normalizes) {
        Light light = state.light();
        Map<String, String> result = new UsdLightValues(prim, light, state.meters(), hasZUp, scale).values(state.isOn());
        double exposure = edited.contains("exposure") && light != before ? 1
                : Math.pow(2, before.emission().exposure() - original.exposure());
        result.put(UsdLightValues.INTENSITY, UsdLayer.number(intensity(light, normalizes, state.meters()) * exposure));
        result.put(UsdLightValues.NORMALIZE, normalizes ? "1" : "0");
        if (isPointWithSize(light, prim)) {
            // Its size in the stage still says how much light a point gives.
            result.put("float inputs:radius", UsdLayer.number(original.radius()));
        }
        if (isInRig() && !prim.equals(UsdLightValues.MESH)) {
            result.put(UsdLightValues.MATRIX, matrix(light));
        }
        return result;
    }

    /** Returns the intensity as a power or as a luminance; not finite if a light without size has no luminance. */
    private double intensity(Light light, boolean normalizes, double meters) {
        double power = new UsdLightValues(type, light, meters, hasZUp, scale).power();
        if (normalizes || light.type() == LightType.DIRECTIONAL && !light.isArea()) {
            return power;
        }
        if (light.isArea()) {
            return IntensityUnit.luminousArea(light) > 0 ? Emission.withUnit(light, IntensityUnit.NIT, meters).intensity() : Double.NaN;
        }
        double radius = original.radius() * LightScales.sphere(scale);
        return isPointWithSize(light, type) ? power / (4 * Math.PI * radius * radius) : Double.NaN;
    }

    /** Returns whether a light without size has a prim with one. */
    private boolean isPointWithSize(Light light, String prim) {
        return prim.equals("SphereLight") && originalType.equals(prim) && light.area().radius() == 0 && original.radius() > 0;
    }

    private boolean isInRig() {
        return original.worldToParent().isPresent();
    }

    /** Returns the transform under the parent. */
    private String matrix(Light light) {
        Transform tilt = UsdLightValues.tilt(hasZUp);
        Transform world = original.world();
        Transform turned = isTurned(light) ? turn(light, tilt).times(world.linearPart()) : world.linearPart();
        Vec3 place = !light.type().hasPosition() || light.position().equals(original.light().position())
                ? world.transformPoint(Vec3.ZERO) : tilt.transformVector(light.position());
        return UsdLightValues.matrix(original.worldToParent().orElseThrow().times(Transform.translation(place)).times(turned));
    }

    private boolean isTurned(Light light) {
        if (light == before) {
            return false;
        }
        boolean hangs = UsdLightValues.hangs(light);
        return edited.contains("type") && (light.type() != LightType.POINT || hangs) || hangs && edited.contains("profile")
                || light.type().hasDirection() && edited.contains("direction")
                || LightAttribute.UP.appliesTo(light.type()) && edited.contains("up");
    }

    private Transform turn(Light light, Transform tilt) {
        Vec3 direction = light.type() == LightType.POINT ? UsdLightValues.DOWN : light.direction().normalized();
        LightFrame old = LightFrame.of(original.world());
        boolean hasTop = light.type() == LightType.RECT || LightAttribute.UP.appliesTo(light.type()) && edited.contains("up");
        return hasTop ? old.to(LightFrame.of(tilt.transformVector(light.area().right(direction)), tilt.transformVector(direction)))
                : LightFrame.shortest(old.z(), tilt.transformVector(direction.times(-1)));
    }
}
