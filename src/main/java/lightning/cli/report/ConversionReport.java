package lightning.cli.report;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * A converted file, of {@code import}, {@code export} and {@code export-lights}.
 *
 * @param output   written file
 * @param objects  number of objects; absent for {@code export-lights}, as the next
 * @param units    units of the lights; absent if the format has only one
 * @param indirect true if the scene has indirect light; absent for exports
 * @param losses   what is left out or approximated, with the number of times
 */
public record ConversionReport(String output, @Nullable Integer objects, @Nullable Integer materials, int lights, @Nullable String units,
        @Nullable Boolean indirect, SortedMap<String, Integer> losses) {
    public ConversionReport(String output, @Nullable Integer objects, @Nullable Integer materials, int lights, @Nullable String units,
            @Nullable Boolean indirect, Map<String, Integer> losses) {
        this(output, objects, materials, lights, units, indirect, new TreeMap<>(losses));
    }
}
