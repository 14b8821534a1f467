package lightning.scene.value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.Stage;

/**
 * Gains of a light on single shapes and groups: factors of all its contributions there. The gain of a group applies to all its shapes; a gain
 * of a shape, or of a group inside, replaces it. Objects without a gain have 1. {@link Stage#gainEntries} resolves the names.
 *
 * @param entries gains with unique names; names that the scene does not have are ignored
 */
public record ShapeGains(List<Entry> entries) {
    /** No gain: 1 everywhere. */
    public static final ShapeGains NONE = new ShapeGains(List.of());

    /**
     * Gain on one shape or group.
     *
     * @param gain factor, 0 … {@link SceneLimits#MAX_GAIN}
     */
    public record Entry(String name, double gain) {
        public Entry {
            SceneLimits.checkName(name);
            SceneLimits.checkRange("gain", gain, 0, SceneLimits.MAX_GAIN);
        }
    }

    /** @throws RefusalException if a name occurs twice, or if there are more than {@link SceneLimits#MAX_LINKS} */
    public ShapeGains {
        entries = List.copyOf(entries);
        SceneLimits.checkRange("the number of gains", entries.size(), 0, SceneLimits.MAX_LINKS);
        if (entries.stream().map(Entry::name).distinct().count() < entries.size()) {
            throw new RefusalException("gains must name each object once");
        }
    }

    /** Returns a gain on one shape or group. */
    public static ShapeGains of(String name, double gain) {
        return NONE.with(name, gain);
    }

    public boolean isNone() {
        return entries.isEmpty();
    }

    /** Returns the names of all shapes and groups with a gain. */
    public List<String> names() {
        return entries.stream().map(Entry::name).toList();
    }

    /** Returns the gain of a shape or group itself; empty if it has none or only its group has one. */
    public Optional<Double> get(String name) {
        return entries.stream().filter(e -> e.name().equals(name)).map(Entry::gain).findFirst();
    }

    /** Returns the largest gain, at least 1. */
    public double max() {
        return entries.stream().mapToDouble(Entry::gain).reduce(1, Math::max);
    }

    /** Returns these gains with that of one shape or group set. */
    public ShapeGains with(String name, double gain) {
        Map<String, Double> gains = new LinkedHashMap<>();
        entries.forEach(e -> gains.put(e.name(), e.gain()));
        gains.put(name, gain);
        return new ShapeGains(gains.entrySet().stream().map(e -> new Entry(e.getKey(), e.getValue())).toList());
    }

    /** Returns these gains without that of one shape or group. */
    public ShapeGains without(String name) {
        return retain(n -> !n.equals(name));
    }

    /** Returns these gains with a shape or a group renamed. */
    public ShapeGains rename(String oldName, String newName) {
        UnaryOperator<Entry> renamed = e -> e.name().equals(oldName) ? new Entry(newName, e.gain()) : e;
        return get(oldName).isEmpty() ? this : new ShapeGains(entries.stream().map(renamed).toList());
    }

    /** Returns these gains without unknown names. */
    public ShapeGains retain(Predicate<String> exists) {
        return entries.stream().allMatch(e -> exists.test(e.name())) ? this
                : new ShapeGains(new ArrayList<>(entries.stream().filter(e -> exists.test(e.name())).toList()));
    }

    /** Formats for the user: {@code none}, or {@code sphere 30 %, floor 0 %}. */
    public String format() {
        return isNone() ? Messages.tr("none")
                : entries.stream().map(e -> Quote.of(e.name()) + " " + formatPercent(e.gain())).collect(Collectors.joining(", "));
    }

    /** Formats a gain for the user: {@code 30 %}. */
    public static String formatPercent(double gain) {
        return SceneLimits.formatShort(gain * 100) + " %";
    }
}
