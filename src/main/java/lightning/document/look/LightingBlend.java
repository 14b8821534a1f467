package lightning.document.look;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.World;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.AreaShape;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.value.ShapeGains;

/**
 * Interpolation between two lightings. Its ends are the lightings themselves. Every position between is a regular lighting, so its image is
 * exact:
 *
 * <ul>
 * <li>Color times intensity is interpolated linearly, and so are positions, angles, sizes, attenuation and all other numbers. A light that
 * is off or muted by a solo counts as 0. Integers take the larger value. Directions follow the great circle.
 * <li>Lights of the same name are interpolated if type, unit, falloff, gobo, profile, texture, links and the objects with a gain are equal. All others fade out or in, renamed if their
 * names are taken. If their visible faces are in the same place, the nearer end's face is shown.
 * <li>Solos stay if they are the same at both ends. Otherwise what they mute fades. This includes the light of the environment, whose image
 * stays.
 * <li>Light groups stay if they are equal at both ends. Otherwise they are merged into their lights.
 * <li>Environments with the same image are interpolated. Otherwise the first fades out in the first half, and the second fades in in the
 * second.
 * <li>Domes of the same name and image are interpolated. All others fade out or in, as lights do.
 * </ul>
 */
public final class LightingBlend {
    /** Cosine from which two unit directions count as equal, or as opposite. */
    private static final double PARALLEL_COSINE = 1 - 1e-12;

    private final Lighting from;
    private final Lighting to;
    private final double t;
    private final boolean hasSameGroups;
    private final boolean hasSameEnvironment;
    private final SoloState fromSolos;
    private final SoloState toSolos;
    /** True if lights, light groups and environment keep their solos. */
    private final boolean keepsSolos;

    private LightingBlend(Lighting from, Lighting to, double t) {
        this.from = from;
        this.to = to;
        this.t = t;
        hasSameGroups = from.rig().lightGroups().equals(to.rig().lightGroups());
        // The sun of a sky moves from one place to the other.
        boolean hasSkies = from.world().sky().on() && to.world().sky().on() && from.world().sky().unit() == to.world().sky().unit();
        hasSameEnvironment = hasSkies || from.world().environment().equals(to.world().environment());
        fromSolos = SoloState.of(from);
        toSolos = SoloState.of(to);
        // In between, another image of the world is that of a named dome, and a sky is dark halfway: the solo of one has no effect then.
        keepsSolos = fromSolos.solos().equals(toSolos.solos())
                && (hasSameEnvironment || !fromSolos.solos().contains(Contribution.ENVIRONMENT));
    }

    /**
     * Returns the lighting at a position.
     *
     * @param t 0 at the start, 1 at the end
     * @throws IllegalArgumentException if it has more lights than a scene can have
     */
    public static Lighting blend(Lighting from, Lighting to, double t) {
        return t <= 0 ? from : t >= 1 ? to : new LightingBlend(from, to, t).lighting();
    }

    private Lighting lighting() {
        List<Light> lights = new ArrayList<>();
        List<Light> added = new ArrayList<>();
        Set<String> takenNames = new HashSet<>();
        from.rig().lightGroups().forEach(toLight -> takenNames.add(toLight.name()));
        to.rig().lightGroups().forEach(toLight -> takenNames.add(toLight.name()));
        from.rig().lights().forEach(l -> takenNames.add(l.name()));
        to.rig().lights().forEach(l -> takenNames.add(l.name()));
        from.world().named().forEach(dome -> takenNames.add(dome.name()));
        to.world().named().forEach(dome -> takenNames.add(dome.name()));
        for (Light fromLight : from.rig().lights()) {
            Optional<Light> toLight = to.rig().light(fromLight.name());
            if (toLight.isPresent() && canInterpolate(fromLight, toLight.get())) {
                lights.add(interpolate(fromLight, toLight.get()));
            } else {
                boolean isSameFace = toLight.isPresent() && isSameFace(fromLight, toLight.get());
                lights.add(withFace(fade(fromSolos, fromLight, 1 - t), !isSameFace || t < 0.5));
                toLight.ifPresent(l -> added.add(withFace(fade(toSolos, l, t), !isSameFace || t >= 0.5)
                        .withName(freeName(l.name(), takenNames))));
            }
        }
        to.rig().lights().stream().filter(toLight -> from.rig().light(toLight.name()).isEmpty())
                .forEach(toLight -> added.add(fade(toSolos, toLight, t)));
        lights.addAll(added);
        DomeBlend blend = new DomeBlend(fromSolos, toSolos, t, keepsSolos);
        List<Dome> domes = blend.domes(name -> freeName(name, takenNames), this::numbers, this::lerp);
        return new Lighting(world(blend).withNamed(domes), LightRig.of(lights, lightGroups()));
    }

    private List<LightGroup> lightGroups() {
        return !hasSameGroups ? List.of()
                : keepsSolos ? from.rig().lightGroups()
                : from.rig().lightGroups().stream().map(group -> group.withSolo(false)).toList();
    }

    private static String freeName(String name, Set<String> takenNames) {
        int number = 2;
        while (!takenNames.add(name + number)) {
            number++;
        }
        return name + number;
    }

    private boolean canInterpolate(Light a, Light b) {
        return a.type() == b.type() && a.falloff() == b.falloff() && a.emission().unit() == b.emission().unit() && a.gobo().equals(b.gobo())
                && a.profile().equals(b.profile()) && a.texture().equals(b.texture())
                && a.illuminates().equals(b.illuminates()) && a.shadowCasters().equals(b.shadowCasters())
                && a.influence().gains().names().equals(b.influence().gains().names())
                && (!hasSameGroups || a.lightGroup().equals(b.lightGroup()));
    }

    /** Returns whether the camera sees two lights as one surface, of which only one can be shown. */
    private static boolean isSameFace(Light a, Light b) {
        AreaShape first = a.area();
        AreaShape last = b.area();
        return a.type() == b.type() && first.visibility() == last.visibility() && a.position().equals(b.position())
                && a.direction().equals(b.direction()) && first.withSamples(last.samples()).equals(last);
    }

    private static Light withFace(Light light, boolean isShown) {
        return isShown ? light : light.withArea(light.area().withVisibility(FaceVisibility.HIDDEN));
    }

    /**
     * Returns a light with its group applied, if groups are merged. Unless solos stay, it is off if it does not contribute, and not solo.
     */
    private Light effectiveLight(SoloState end, Light light) {
        Light effective = hasSameGroups ? light : end.lighting().rig().effectiveLight(light);
        // A light that is off has no effect by its solo, and must not get one when it is on at the other end.
        return keepsSolos ? effective.withSolo(effective.solo() && effective.on())
                : effective.withOn(end.isActive(light)).withSolo(false);
    }

    private Light fade(SoloState end, Light light, double share) {
        Light effective = effectiveLight(end, light);
        return effective.withIntensity(effective.intensity() * share);
    }

    private Light interpolate(Light a, Light b) {
        Light first = effectiveLight(fromSolos, a);
        Light last = effectiveLight(toSolos, b);
        Light light = first;
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            light = interpolateAttribute(attribute, light, first, last);
        }
        double fromIntensity = first.on() ? first.intensity() : 0;
        double toIntensity = last.on() ? last.intensity() : 0;
        double intensity = lerp(fromIntensity, toIntensity);
        return light.withDirection(slerp(first.direction(), last.direction()))
                .withArea(light.area().withUp(slerp(first.area().up(), last.area().up())))
                .withIntensity(first.on() || last.on() ? intensity : lerp(first.intensity(), last.intensity()))
                .withColor(color(first.color(), fromIntensity, last.color(), toIntensity))
                .withInfluence(light.influence().withGains(gains(first.influence().gains(), last.influence().gains())))
                .withOn(first.on() || last.on());
    }

    /** Interpolates gains on the same objects. */
    private ShapeGains gains(ShapeGains a, ShapeGains b) {
        return new ShapeGains(a.entries().stream()
                .map(e -> new ShapeGains.Entry(e.name(), lerp(e.gain(), b.get(e.name()).orElseThrow()))).toList());
    }

    /**
     * Returns the color that makes mean intensity times color the mean of both products. It lies between the two colors, so within their
     * range.
     */
    private Rgb color(Rgb a, double fromIntensity, Rgb b, double toIntensity) {
        double share = fromIntensity == toIntensity ? t : t * toIntensity / lerp(fromIntensity, toIntensity);
        return a.equals(b) ? a : lerp(a, b, share);
    }

    private static Rgb lerp(Rgb a, Rgb b, double share) {
        return new Rgb(lerp(a.r(), b.r(), share), lerp(a.g(), b.g(), share), lerp(a.b(), b.b(), share));
    }

    private double lerp(double a, double b) {
        return lerp(a, b, t);
    }

    private static double lerp(double a, double b, double share) {
        return a == b ? a : Math.clamp((1 - share) * a + share * b, Math.min(a, b), Math.max(a, b));
    }

    /** Interpolates numbers linearly, integers to the larger; keeps all other attributes. */
    private <T, V> T interpolateAttribute(SceneAttribute<T, V> attribute, T to, T first, T last) {
        if (!(attribute.kind() instanceof NumericKind<V> quantity)) {
            return to;
        }
        V value = attribute.get(first);
        for (int i = 0; i < quantity.labels().size(); i++) {
            double a = quantity.number(attribute.get(first), i);
            double b = quantity.number(attribute.get(last), i);
            double mean = quantity.integer() ? Math.max(a, b) : lerp(a, b);
            // An opposite direction would pass through length 0; it is rotated afterwards.
            value = quantity.form() == NumericKind.Form.DIRECTION ? value : quantity.with(value, i, mean);
        }
        return attribute.with(to, value);
    }

    /** Interpolates along the great circle at length 1; returns equal directions unchanged. */
    private Vec3 slerp(Vec3 from, Vec3 to) {
        if (from.equals(to)) {
            return from;
        }
        Vec3 a = from.normalized();
        Vec3 b = to.normalized();
        double cos = a.dot(b);
        if (cos >= PARALLEL_COSINE) {
            return b;
        }
        if (cos <= -PARALLEL_COSINE) {
            // All great circles are equally short: uses the axis farthest from the direction.
            Vec3 side = a.cross(Math.abs(a.y()) < 0.5 ? Vec3.Y : new Vec3(1, 0, 0)).normalized();
            return a.times(Math.cos(Math.PI * t)).plus(side.times(Math.sin(Math.PI * t)));
        }
        double angle = Math.acos(cos);
        return a.times(Math.sin((1 - t) * angle)).plus(b.times(Math.sin(t * angle))).times(1 / Math.sin(angle));
    }

    /** Interpolates all numbers of domes. */
    private Dome numbers(Dome first, Dome last) {
        Dome dome = first;
        for (SceneAttribute<Dome, ?> attribute : Dome.ATTRIBUTES) {
            dome = interpolateAttribute(attribute, dome, first, last);
        }
        return dome;
    }

    private World world(DomeBlend blend) {
        World world = from.world();
        for (SceneAttribute<World, ?> attribute : World.ATTRIBUTES) {
            world = interpolateAttribute(attribute, world, from.world(), to.world());
        }
        Dome numbers = world.own();
        if (hasSameEnvironment) {
            return world.withOwn(_ -> blend.interpolated(from.world().own(), to.world().own(), (_, _) -> numbers, this::lerp));
        }
        return world.withOwn(_ -> blend.otherOwn());
    }
}
