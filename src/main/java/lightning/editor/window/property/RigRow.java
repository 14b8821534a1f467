package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import lightning.scene.Rig;

/** One line of the list of lights, by a place in the scene: what stands there is the cell's to show. */
sealed interface RigRow {
    record OfLight(int place) implements RigRow {}

    record OfBank(int place) implements RigRow {}

    /**
     * All lines: first the lights in no bank, then each bank with its lights, everything in the scene's order.
     *
     * @param folded the names of banks whose lights are not listed
     */
    static List<RigRow> of(Rig rig, Set<String> folded) {
        List<RigRow> rows = new ArrayList<>(members(rig, ""));
        for (int i = 0; i < rig.banks().size(); i++) {
            String bank = rig.banks().get(i).name();
            rows.add(new OfBank(i));
            rows.addAll(folded.contains(bank) ? List.of() : members(rig, bank));
        }
        return rows;
    }

    private static List<OfLight> members(Rig rig, String bank) {
        return IntStream.range(0, rig.lights().size()).filter(i -> rig.lights().get(i).bank().equals(bank)).mapToObj(OfLight::new).toList();
    }
}
