package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.scene.value.SceneLimits;

/**
 * Whether a light shines.
 *
 * @param on         true if switched on
 * @param solo       true if soloed: if any light is solo, all others are dark
 * @param lightGroup name of its light group, whose switches act too; empty for none
 */
@RecordBuilder
public record Switches(boolean on, boolean solo, String lightGroup) implements SwitchesBuilder.With {
    /** Initial values of a light: on, in no group. */
    public static final Switches DEFAULT = new Switches(true, false, "");

    /** @throws IllegalArgumentException if a group has no name that a scene allows */
    public Switches {
        if (!lightGroup.isEmpty()) {
            SceneLimits.checkName(lightGroup);
        }
    }
}
