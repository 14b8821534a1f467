package lightning.document.look;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.function.DoubleBinaryOperator;
import java.util.function.UnaryOperator;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.SceneElement;

/**
 * Interpolation between the domes of two lightings. Domes with the same name and image are interpolated; all others fade out or in, side by
 * side.
 *
 * @param from       solos at the start
 * @param to         solos at the end
 * @param t          position, 0 … 1
 * @param keepsSolos true if solos stay; otherwise what they mute fades
 */
record DomeBlend(SoloState from, SoloState to, double t, boolean keepsSolos) {
    /**
     * Returns the domes at the position.
     *
     * @param freeName returns a name that no object has yet
     * @param numbers  interpolates the numbers of two domes
     * @param lerp     interpolates two numbers
     */
    List<Dome> domes(UnaryOperator<String> freeName, BinaryOperator<Dome> numbers, DoubleBinaryOperator lerp) {
        List<Dome> domes = new ArrayList<>();
        List<Dome> added = new ArrayList<>();
        for (Dome first : from.lighting().world().named()) {
            Optional<Dome> last = to.lighting().world().dome(first.name());
            if (last.isPresent() && last.get().image().equals(first.image())) {
                domes.add(interpolated(first, last.get(), numbers, lerp).withName(name(first, freeName)));
            } else {
                domes.add(faded(from, first, 1 - t).withName(name(first, freeName)));
                last.ifPresent(dome -> added.add(faded(to, dome, t).withName(freeName.apply(dome.name()))));
            }
        }
        to.lighting().world().named().stream().filter(dome -> from.lighting().world().dome(dome.name()).isEmpty())
                .forEach(dome -> added.add(faded(to, dome, t).withName(name(dome, freeName))));
        Dome own = to.lighting().world().own();
        if (hasTwoImages()) {
            added.add(faded(to, own, t).withName(freeName.apply("environment")));
        }
        domes.addAll(added);
        return domes;
    }

    /** Returns whether the worlds have different images of their own, which are both shown in between. */
    private boolean hasTwoImages() {
        Dome first = from.lighting().world().own();
        Dome last = to.lighting().world().own();
        return first.image().isPresent() && last.image().isPresent() && !first.sky().on() && !last.sky().on()
                && !first.image().equals(last.image());
    }

    /**
     * Returns the world's own environment at the position, if it is another one at the end. A sky or none at either end follows the image of
     * the other or leads to it.
     */
    Dome otherOwn() {
        if (hasTwoImages()) {
            return faded(from, from.lighting().world().own(), 1 - t);
        }
        SoloState nearer = t < 0.5 ? from : to;
        Dome shown = nearer.lighting().world().own();
        return shown.withIntensity(shown.intensity() * Math.abs(1 - 2 * t)).withGain(gain(nearer, shown))
                .withSolo(keepsSolos && from.solos().contains(Contribution.ENVIRONMENT));
    }

    /** Returns the name of a dome, another one if a light at either end has it. */
    private String name(Dome dome, UnaryOperator<String> freeName) {
        boolean isTaken = from.lighting().rig().isNameUsed(dome.name()) || to.lighting().rig().isNameUsed(dome.name());
        return isTaken ? freeName.apply(dome.name()) : dome.name();
    }

    private Dome faded(SoloState end, Dome dome, double share) {
        return dome.withIntensity(dome.intensity() * share).withGain(gain(end, dome)).withSolo(keepsSolos && dome.solo());
    }

    /** Returns the light gain at an end; 0 if a solo mutes the dome and does not stay. */
    private double gain(SoloState end, Dome dome) {
        return !keepsSolos && dome.isPresent() && end.isMuted(new SceneElement.OfDome(dome.name())) ? 0 : dome.gain();
    }

    /** Returns the mean of a dome of both ends; parameters as above. */
    Dome interpolated(Dome first, Dome last, BinaryOperator<Dome> numbers, DoubleBinaryOperator lerp) {
        double fromIntensity = first.on() ? first.intensity() : 0;
        double toIntensity = last.on() ? last.intensity() : 0;
        boolean isOn = first.on() || last.on();
        double intensity = isOn ? lerp.applyAsDouble(fromIntensity, toIntensity) : lerp.applyAsDouble(first.intensity(), last.intensity());
        double fromGain = gain(from, first);
        double toGain = gain(to, last);
        // Image and light are linear: a dark image has no say in the gain.
        double gain = !isOn || intensity == 0 ? lerp.applyAsDouble(fromGain, toGain)
                : lerp.applyAsDouble(fromIntensity * fromGain, toIntensity * toGain) / intensity;
        return numbers.apply(first, last).withIntensity(intensity)
                .withGain(Math.clamp(gain, Math.min(fromGain, toGain), Math.max(fromGain, toGain)))
                .withOn(isOn).withSolo(keepsSolos && from.solos().contains(new SceneElement.OfDome(first.name())));
    }
}
