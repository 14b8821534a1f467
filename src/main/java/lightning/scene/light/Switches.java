package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.text.Messages;
import lightning.scene.attribute.ValueKind;

/**
 * Whether a light shines.
 *
 * @param on         true if switched on
 * @param solo       true if soloed: if any light is solo, all others are dark
 * @param lightGroup name of its light group, whose switches act too; empty for none
 */
@RecordBuilder
public record Switches(boolean on, boolean solo, String lightGroup) implements SwitchesBuilder.With {
    static final ValueKind.NameKind GROUPS =
            new ValueKind.NameKind(ValueKind.NameKind.Referent.LIGHT_GROUP, Messages.key("Light group of this light"));

    /** Initial values of a light: on, in no group. */
    public static final Switches DEFAULT = new Switches(true, false, "");

    /** @throws IllegalArgumentException if a group has no name that a scene allows */
    public Switches {
        GROUPS.check("bank", lightGroup);
    }
}
