package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.scene.LightRig;

/** One line of the list of lights, by a place in the scene: what stands there is the cell's to show. */
sealed interface LightListRow {
    record LightRow(int index) implements LightListRow {}

    record GroupRow(int index) implements LightListRow {}

    /**
     * All lines: first the lights in no bank, then each bank with its lights, everything in the scene's order.
     *
     * @param collapsedGroups the names of banks whose lights are not listed
     */
    static List<LightListRow> of(LightRig rig, Set<String> collapsedGroups) {
        List<LightListRow> rows = new ArrayList<>(members(rig, ""));
        for (int i = 0; i < rig.lightGroups().size(); i++) {
            String bank = rig.lightGroups().get(i).name();
            rows.add(new GroupRow(i));
            rows.addAll(collapsedGroups.contains(bank) ? List.of() : members(rig, bank));
        }
        return rows;
    }

    private static List<LightRow> members(LightRig rig, String bank) {
        return IntStream.range(0, rig.lights().size()).filter(i -> rig.lights().get(i).lightGroup().equals(bank)).mapToObj(LightRow::new)
                .toList();
    }
}
