package lightning.editor.document.cue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import lightning.scene.NumericKind;
import lightning.scene.SceneAttribute;
import lightning.scene.World;

/**
 * The way from one lighting to another. At its ends it is these themselves; between them it is a lighting like any other, so that its picture
 * is exact at every position:
 *
 * <ul>
 * <li>Color times intensity goes linearly, a light that is off or silenced by a solo counting as 0, and so do places, angles, sizes,
 * attenuation and all other numbers; of whole numbers the larger holds. Directions go along the great circle.
 * <li>A light goes on in the light of its name where both have the same type, gobo, profile and links. All others fade: those of the
 * begin out, those of the end in, under a free name where theirs is taken.
 * <li>Banks stay where they are the same at both ends. Else they are folded into their lights.
 * <li>An environment goes on in the same picture. Another fades out in the first half, and the new one in in the second.
 * </ul>
 */
public final class LightingBlend {
    /** Of two directions of length 1, the cosine from which on they are taken as the same, or as opposite. */
    private static final double PARALLEL_COSINE = 1 - 1e-12;

    private final Lighting from;
    private final Lighting to;
    private final double t;
    private final boolean hasSameGroups;

    private LightingBlend(Lighting from, Lighting to, double t) {
        this.from = from;
        this.to = to;
        this.t = t;
        hasSameGroups = from.rig().lightGroups().equals(to.rig().lightGroups());
    }

    /**
     * The lighting at a position of the way.
     *
     * @param t 0 at its begin, 1 at its end
     * @throws IllegalArgumentException if it has more lights than a scene may have
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
        for (Light fromLight : from.rig().lights()) {
            Optional<Light> toLight = to.rig().light(fromLight.name());
            if (toLight.isPresent() && canInterpolate(fromLight, toLight.get())) {
                lights.add(interpolate(fromLight, toLight.get()));
            } else {
                lights.add(fade(from.rig(), fromLight, 1 - t));
                toLight.ifPresent(l -> added.add(fade(to.rig(), l, t).withName(freeName(l.name(), takenNames))));
            }
        }
        to.rig().lights().stream().filter(toLight -> from.rig().light(toLight.name()).isEmpty())
                .forEach(toLight -> added.add(fade(to.rig(), toLight, t)));
        lights.addAll(added);
        List<LightGroup> banks = hasSameGroups ? from.rig().lightGroups() : List.of();
        return new Lighting(world(), LightRig.of(lights, banks));
    }

    private static String freeName(String name, Set<String> takenNames) {
        int number = 2;
        while (!takenNames.add(name + number)) {
            number++;
        }
        return name + number;
    }

    private boolean canInterpolate(Light a, Light b) {
        return a.type() == b.type() && a.gobo().equals(b.gobo()) && a.profile().equals(b.profile())
                && a.illuminates().equals(b.illuminates()) && a.shadowedBy().equals(b.shadowedBy())
                && (!hasSameGroups || a.lightGroup().equals(b.lightGroup()));
    }

    /** A light as it shines by its own switches and solo, or by its bank's too where banks do not stay; off where it is dark. */
    private Light effectiveLight(LightRig rig, Light light) {
        Light effective = hasSameGroups ? light : rig.effectiveLight(light);
        return effective.withOn(rig.isActive(light)).withSolo(false);
    }

    private Light fade(LightRig rig, Light light, double share) {
        Light effective = effectiveLight(rig, light);
        return effective.withIntensity(effective.intensity() * share);
    }

    private Light interpolate(Light a, Light b) {
        Light first = effectiveLight(from.rig(), a);
        Light last = effectiveLight(to.rig(), b);
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
                .withOn(first.on() || last.on());
    }

    /** The color by which the mean intensity is the mean weight: between the two colors, so within their range. */
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

    /** What is made of numbers goes linearly, whole ones to the larger; all else stays. */
    private <T, V> T interpolateAttribute(SceneAttribute<T, V> attribute, T to, T first, T last) {
        if (!(attribute.kind() instanceof NumericKind<V> quantity)) {
            return to;
        }
        V value = attribute.get(first);
        for (int i = 0; i < quantity.labels().size(); i++) {
            double a = quantity.number(attribute.get(first), i);
            double b = quantity.number(attribute.get(last), i);
            double mean = quantity.integer() ? Math.max(a, b) : lerp(a, b);
            // A direction that is opposite would have no length on its way; it is turned later.
            value = quantity.form() == NumericKind.Form.DIRECTION ? value : quantity.with(value, i, mean);
        }
        return attribute.with(to, value);
    }

    /** Along the great circle, at length 1; the same where both are the same. */
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
            // Every way is as short: about the axis that is farthest from the direction.
            Vec3 side = a.cross(Math.abs(a.y()) < 0.5 ? Vec3.Y : new Vec3(1, 0, 0)).normalized();
            return a.times(Math.cos(Math.PI * t)).plus(side.times(Math.sin(Math.PI * t)));
        }
        double angle = Math.acos(cos);
        return a.times(Math.sin((1 - t) * angle)).plus(b.times(Math.sin(t * angle))).times(1 / Math.sin(angle));
    }

    private World world() {
        World first = from.world();
        World last = to.world();
        World world = first;
        for (SceneAttribute<World, ?> attribute : World.ATTRIBUTES) {
            world = interpolateAttribute(attribute, world, first, last);
        }
        if (first.environment().equals(last.environment())) {
            return world;
        }
        World environmentSource = t < 0.5 ? first : last;
        return world.withEnvironment(environmentSource.environment()).withRotation(environmentSource.rotation())
                .withLightCount(environmentSource.lightCount())
                .withSoftness(environmentSource.softness()).withIntensity(environmentSource.intensity() * Math.abs(1 - 2 * t));
    }
}
