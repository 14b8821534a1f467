package lightning.editor.document.cue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Quantity;
import lightning.scene.Rig;
import lightning.scene.World;

/**
 * The way from one lighting to another. At its ends it is these themselves; between them it is a lighting like any other, so that its picture
 * is exact at every position:
 *
 * <ul>
 * <li>Colour times intensity goes linearly, a light that is off or silenced by a solo counting as 0, and so do places, angles, sizes,
 * attenuation and all other numbers; of whole numbers the larger holds. Directions go along the great circle.
 * <li>A light goes on in the light of its name where both have the same type, gobo, profile and links. All others fade: those of the
 * begin out, those of the end in, under a free name where theirs is taken.
 * <li>Banks stay where they are the same at both ends. Else they are folded into their lights.
 * <li>An environment goes on in the same picture. Another fades out in the first half, and the new one in in the second.
 * </ul>
 */
public final class LightingBlend {
    /** Of two directions of length 1, the cosine from which on they are taken as the same, or as opposite. */
    private static final double NEAR = 1 - 1e-12;

    private final Lighting from;
    private final Lighting to;
    private final double t;
    private final boolean banked;

    private LightingBlend(Lighting from, Lighting to, double t) {
        this.from = from;
        this.to = to;
        this.t = t;
        banked = from.rig().banks().equals(to.rig().banks());
    }

    /**
     * The lighting at a position of the way.
     *
     * @param t 0 at its begin, 1 at its end
     * @throws IllegalArgumentException if it has more lights than a scene may have
     */
    public static Lighting at(Lighting from, Lighting to, double t) {
        return t <= 0 ? from : t >= 1 ? to : new LightingBlend(from, to, t).lighting();
    }

    private Lighting lighting() {
        List<Light> lights = new ArrayList<>();
        List<Light> added = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        from.rig().banks().forEach(b -> taken.add(b.name()));
        to.rig().banks().forEach(b -> taken.add(b.name()));
        from.rig().lights().forEach(l -> taken.add(l.name()));
        to.rig().lights().forEach(l -> taken.add(l.name()));
        for (Light a : from.rig().lights()) {
            Optional<Light> b = to.rig().light(a.name());
            if (b.isPresent() && goesOn(a, b.get())) {
                lights.add(between(a, b.get()));
            } else {
                lights.add(faded(from.rig(), a, 1 - t));
                b.ifPresent(l -> added.add(faded(to.rig(), l, t).withName(free(l.name(), taken))));
            }
        }
        to.rig().lights().stream().filter(b -> from.rig().light(b.name()).isEmpty()).forEach(b -> added.add(faded(to.rig(), b, t)));
        lights.addAll(added);
        List<Bank> banks = banked ? from.rig().banks() : List.of();
        return new Lighting(world(), Rig.of(lights, banks));
    }

    private static String free(String name, Set<String> taken) {
        int number = 2;
        while (!taken.add(name + number)) {
            number++;
        }
        return name + number;
    }

    private boolean goesOn(Light a, Light b) {
        return a.type() == b.type() && a.gobo().equals(b.gobo()) && a.profile().equals(b.profile())
                && a.illuminates().equals(b.illuminates()) && a.shadowedBy().equals(b.shadowedBy())
                && (!banked || a.bank().equals(b.bank()));
    }

    /** A light as it shines by its own switches and solo, or by its bank's too where banks do not stay; off where it is dark. */
    private Light shown(Rig rig, Light light) {
        Light acting = banked ? light : rig.acting(light);
        return acting.withOn(rig.shines(light)).withSolo(false);
    }

    private Light faded(Rig rig, Light light, double share) {
        Light shown = shown(rig, light);
        return shown.withIntensity(shown.intensity() * share);
    }

    private Light between(Light a, Light b) {
        Light first = shown(from.rig(), a);
        Light last = shown(to.rig(), b);
        Light light = first;
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            light = number(attribute, light, first, last);
        }
        double was = first.on() ? first.intensity() : 0;
        double is = last.on() ? last.intensity() : 0;
        double intensity = mean(was, is);
        return light.withDirection(turned(first.direction(), last.direction()))
                .withArea(light.area().withUp(turned(first.area().up(), last.area().up())))
                .withIntensity(first.on() || last.on() ? intensity : mean(first.intensity(), last.intensity()))
                .withColor(color(first.color(), was, last.color(), is))
                .withOn(first.on() || last.on());
    }

    /** The colour by which the mean intensity is the mean weight: between the two colours, so within their range. */
    private Rgb color(Rgb a, double was, Rgb b, double is) {
        double share = was == is ? t : t * is / mean(was, is);
        return a.equals(b) ? a : mean(a, b, share);
    }

    private static Rgb mean(Rgb a, Rgb b, double share) {
        return new Rgb(mean(a.r(), b.r(), share), mean(a.g(), b.g(), share), mean(a.b(), b.b(), share));
    }

    private double mean(double a, double b) {
        return mean(a, b, t);
    }

    private static double mean(double a, double b, double share) {
        return a == b ? a : Math.clamp((1 - share) * a + share * b, Math.min(a, b), Math.max(a, b));
    }

    /** What is made of numbers goes linearly, whole ones to the larger; all else stays. */
    private <T, V> T number(Attribute<T, V> attribute, T to, T first, T last) {
        if (!(attribute.kind() instanceof Quantity<V> quantity)) {
            return to;
        }
        V value = attribute.of(first);
        for (int i = 0; i < quantity.labels().size(); i++) {
            double a = quantity.number(attribute.of(first), i);
            double b = quantity.number(attribute.of(last), i);
            double mean = quantity.whole() ? Math.max(a, b) : mean(a, b);
            // A direction that is opposite would have no length on its way; it is turned later.
            value = quantity.form() == Quantity.Form.DIRECTION ? value : quantity.with(value, i, mean);
        }
        return attribute.with(to, value);
    }

    /** Along the great circle, at length 1; the same where both are the same. */
    private Vec3 turned(Vec3 from, Vec3 to) {
        if (from.equals(to)) {
            return from;
        }
        Vec3 a = from.normalized();
        Vec3 b = to.normalized();
        double cos = a.dot(b);
        if (cos >= NEAR) {
            return b;
        }
        if (cos <= -NEAR) {
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
        for (Attribute<World, ?> attribute : World.ATTRIBUTES) {
            world = number(attribute, world, first, last);
        }
        if (first.environment().equals(last.environment())) {
            return world;
        }
        World shown = t < 0.5 ? first : last;
        return world.withEnvironment(shown.environment()).withRotation(shown.rotation()).withLamps(shown.lamps())
                .withSoftness(shown.softness()).withIntensity(shown.intensity() * Math.abs(1 - 2 * t));
    }
}
