package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.scene.light.LightRig;

/** Row of the light list, by index in the scene. Cells look up the content. */
sealed interface LightListRow {
    record LightRow(int index) implements LightListRow {}

    record GroupRow(int index) implements LightListRow {}

    /**
     * Returns all rows: lights without a group first, then each light group with its lights, in scene order.
     *
     * @param collapsedGroups  names of the collapsed light groups
     */
    static List<LightListRow> of(LightRig rig, Set<String> collapsedGroups) {
        List<LightListRow> rows = new ArrayList<>(members(rig, ""));
        for (int i = 0; i < rig.lightGroups().size(); i++) {
            String group = rig.lightGroups().get(i).name();
            rows.add(new GroupRow(i));
            rows.addAll(collapsedGroups.contains(group) ? List.of() : members(rig, group));
        }
        return rows;
    }

    private static List<LightRow> members(LightRig rig, String group) {
        return IntStream.range(0, rig.lights().size()).filter(i -> rig.lights().get(i).lightGroup().equals(group)).mapToObj(LightRow::new)
                .toList();
    }
}
