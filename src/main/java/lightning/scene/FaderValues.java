package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;

/**
 * What a fader, its color and its switches control: values of a light, a light group or an environment.
 *
 * @param intensity factor of its light, ≥ 0
 * @param color     linear color of a light, or the gel of a group; empty for an environment
 * @param on        false if it is muted
 * @param solo      true if it is soloed
 */
@RecordBuilder
public record FaderValues(double intensity, Optional<Rgb> color, boolean on, boolean solo) implements FaderValuesBuilder.With {}
