package lightning.bench.report;

import java.util.List;
import lightning.bench.result.EffectResult;
import lightning.bench.result.SceneResult;

/** Table of a scene's effects: costs of used ones, savings from absent ones. */
final class EffectTable {
    private EffectTable() {}

    static void write(HtmlWriter page, SceneResult scene) {
        if (!scene.effects().isEmpty()) {
            rows(page, "Effects in use: cost of each",
                    scene.effects().stream().filter(EffectResult::inUse).toList());
            rows(page, "Absent effects: cost of each if it were computed",
                    scene.effects().stream().filter(e -> !e.inUse()).toList());
        }
    }

    private static void rows(HtmlWriter page, String caption, List<EffectResult> effects) {
        if (effects.isEmpty()) {
            return;
        }
        try (HtmlTable table =
                new HtmlTable(page, "edits", caption, "effect", "first pass", "noise", "moved light", "cache", "rays", "used by")) {
            for (EffectResult effect : effects) {
                table.row(effect.effect(), NumberText.ms(effect.certainFirstMs()), "± " + NumberText.ms(effect.noiseMs()),
                        NumberText.ms(effect.certainUpdateMs()),
                        NumberText.bytes(effect.bytes()), NumberText.grouped(effect.rays()), callers(effect));
            }
        }
    }

    private static String callers(EffectResult effect) {
        return effect.callers().isEmpty() ? "" : effect.callers().size() == 1 ? effect.callers().getFirst()
                : effect.callers().getFirst() + " and " + (effect.callers().size() - 1) + " more";
    }
}
