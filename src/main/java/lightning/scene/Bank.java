package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.List;
import lightning.base.math.Rgb;

/**
 * Lights that are mastered together, as by one fader of a lighting desk: a light may belong to one, by its name
 * ({@link Light#bank}), and each light's own settings stay what they are. {@link Rig#acting} tells what the lights become.
 *
 * @param name      unique among all shapes, groups, lights and banks
 * @param color     a gel before all of its lights: linear factors of their colours, 0 … 1
 * @param intensity the master: a factor of their intensities, 0 … 1000
 * @param on        whether any of them shines
 * @param solo      whether they are all solo
 */
@RecordBuilder
public record Bank(String name, Rgb color, double intensity, boolean on, boolean solo) implements BankBuilder.With {
    public static final Attribute<Bank, Rgb> COLOR = new Attribute<>("color", "color", Quantity.color(1), Rgb.WHITE,
            "linear factors of the lights' colours", Bank::color, Bank::withColor);
    public static final Attribute<Bank, Double> INTENSITY = new Attribute<>("intensity", "intensity",
            Quantity.number(0, Limits.MAX_BANK_INTENSITY, 0.1), 1.0, "factor of the lights' intensities", Bank::intensity,
            Bank::withIntensity);
    public static final Attribute<Bank, Boolean> ON = new Attribute<>("on", "on", Choice.YES_OR_NO, true, "", Bank::on, Bank::withOn);
    public static final Attribute<Bank, Boolean> SOLO = new Attribute<>("solo", "solo", Choice.YES_OR_NO, false, "", Bank::solo,
            Bank::withSolo);

    /** All of them, in the order in which a file writes them. */
    public static final List<Attribute<Bank, ?>> ATTRIBUTES = List.of(COLOR, INTENSITY, ON, SOLO);

    public Bank {
        Limits.name(name);
        COLOR.check(color);
        INTENSITY.check(intensity);
    }

    /** A bank that leaves its lights as they are. */
    public static Bank of(String name) {
        return new Bank(name, COLOR.initial(), INTENSITY.initial(), ON.initial(), SOLO.initial());
    }

    /**
     * A light as it shines in this bank, and in none: the factors are multiplied into its colour and its intensity, which stays at
     * most {@link Limits#MAX_INTENSITY}.
     */
    Light acting(Light light) {
        return light.withBank("").withColor(light.color().times(color))
                .withIntensity(Math.min(light.intensity() * intensity, Limits.MAX_INTENSITY))
                .withOn(light.on() && on).withSolo(light.solo() || solo);
    }
}
