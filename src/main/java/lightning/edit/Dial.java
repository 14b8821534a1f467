package lightning.edit;

import java.util.Optional;
import java.util.OptionalDouble;
import lightning.math.Rgb;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.Limits;
import lightning.scene.Scene;
import lightning.text.Decimal;
import lightning.text.Quote;

/**
 * One number that an arrow widget or a slider of the property editor turns (paper §3.2, Figure 5): of the selected
 * light, or of the whole scene.
 */
public enum Dial {
    RED("red", 0.1, Limits.MAX_LIGHT_COLOR, Attribute.COLOR),
    GREEN("green", 0.1, Limits.MAX_LIGHT_COLOR, Attribute.COLOR),
    BLUE("blue", 0.1, Limits.MAX_LIGHT_COLOR, Attribute.COLOR),
    INTENSITY("intensity", 0.1, Limits.MAX_INTENSITY, Attribute.INTENSITY),
    CONSTANT("attenuation constant", 0.1, Limits.MAX_ATTENUATION, Attribute.ATTENUATION),
    LINEAR("attenuation linear", 0.1, Limits.MAX_ATTENUATION, Attribute.ATTENUATION),
    QUADRATIC("attenuation quadratic", 0.1, Limits.MAX_ATTENUATION, Attribute.ATTENUATION),
    ANGLE("angle", 1, Limits.MAX_ANGLE, Attribute.ANGLE),
    DROPOFF("dropoff", 0.1, Limits.MAX_DROPOFF, Attribute.DROPOFF),
    /** Of the scene. */
    AMBIENCE("ambience", 0.1, Limits.MAX_AMBIENCE, null),
    /** Of the scene: mirror bounces, whole. */
    DEPTH("depth", 1, Limits.MAX_DEPTH, null);

    private final String title;
    private final double step;
    private final double max;
    private final Attribute attribute;

    Dial(String title, double step, double max, Attribute attribute) {
        this.title = title;
        this.step = step;
        this.max = max;
        this.attribute = attribute;
    }

    /** For people, lower case. */
    public String title() {
        return title;
    }

    /** What one click adds: 0.1, a degree, or a bounce; and the limits. */
    public Steps steps() {
        return new Steps(step, 0, max);
    }

    /** The largest value allowed; the least is always 0. */
    public double max() {
        return max;
    }

    /** Whether it belongs to the scene and needs no light. */
    public boolean isOfScene() {
        return attribute == null;
    }

    /**
     * The value shown.
     *
     * @param light the name of a light of the scene; not looked at where {@link #isOfScene()}
     * @throws IllegalArgumentException if it is needed and there is none of that name
     */
    public double value(Scene scene, String light) {
        return switch (this) {
            case AMBIENCE -> scene.world().ambience();
            case DEPTH -> scene.picture().depth();
            case RED, GREEN, BLUE, INTENSITY, CONSTANT, LINEAR, QUADRATIC, ANGLE, DROPOFF -> of(LightEdits.light(scene, light));
        };
    }

    /** Sets the value; refused outside 0…{@link #max()}, and for the depth if it is not whole. */
    public Change set(Scene scene, String light, double value) {
        return Change.of(() -> {
            Limits.range(title, value, 0, max);
            return switch (this) {
                case AMBIENCE -> scene.withWorld(scene.world().withAmbience(value));
                case DEPTH -> scene.withPicture(scene.picture().withDepth(whole(value)));
                case RED, GREEN, BLUE, INTENSITY, CONSTANT, LINEAR, QUADRATIC, ANGLE, DROPOFF ->
                        scene.withLight(on(LightEdits.light(scene, light), value));
            };
        });
    }

    /** Sets the value that a person typed; refused if it is no number, and as {@link #set}. */
    public Change typed(Scene scene, String light, String text) {
        OptionalDouble number = Decimal.read(text.strip());
        return number.isPresent() ? set(scene, light, number.getAsDouble())
                : new Change.Refused(title + " must be a number, was " + Quote.of(text.strip()));
    }

    /**
     * Clicks the widget: adds steps, in decimal so that 1.1 and one step make 1.2, and stops at the limits.
     *
     * @param steps how many, down where negative
     */
    public Change stepped(Scene scene, String light, int steps) {
        return Change.of(() -> set(scene, light, steps().from(value(scene, light), steps)).or(scene));
    }

    /** Why it cannot be turned: a clause; empty if it can. */
    public Optional<String> obstacle(Optional<Light> selected) {
        if (attribute == null) {
            return Optional.empty();
        }
        return selected.isEmpty() ? Optional.of("no light is selected") : attribute.obstacle(selected.get().type());
    }

    private double of(Light light) {
        return switch (this) {
            case RED -> light.color().r();
            case GREEN -> light.color().g();
            case BLUE -> light.color().b();
            case INTENSITY -> light.intensity();
            case CONSTANT -> light.attenuation().constant();
            case LINEAR -> light.attenuation().linear();
            case QUADRATIC -> light.attenuation().quadratic();
            case ANGLE -> light.angle();
            case DROPOFF -> light.dropoff();
            case AMBIENCE, DEPTH -> throw new IllegalStateException(title + " is the scene's");
        };
    }

    private Light on(Light light, double v) {
        Rgb c = light.color();
        Attenuation a = light.attenuation();
        return switch (this) {
            case RED -> light.withColor(new Rgb(v, c.g(), c.b()));
            case GREEN -> light.withColor(new Rgb(c.r(), v, c.b()));
            case BLUE -> light.withColor(new Rgb(c.r(), c.g(), v));
            case INTENSITY -> light.withIntensity(v);
            case CONSTANT -> light.withAttenuation(new Attenuation(v, a.linear(), a.quadratic()));
            case LINEAR -> light.withAttenuation(new Attenuation(a.constant(), v, a.quadratic()));
            case QUADRATIC -> light.withAttenuation(new Attenuation(a.constant(), a.linear(), v));
            case ANGLE -> light.withAngle(v);
            case DROPOFF -> light.withDropoff(v);
            case AMBIENCE, DEPTH -> throw new IllegalStateException(title + " is the scene's");
        };
    }

    private int whole(double value) {
        if (value != Math.rint(value)) {
            throw new IllegalArgumentException(title + " must be a whole number, was " + Limits.text(value));
        }
        return (int) value;
    }
}
