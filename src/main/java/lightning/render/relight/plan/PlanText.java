package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Texts;

/** Puts a plan into words. */
final class PlanText {
    /** So many lights are told by the first and the last. */
    private static final int MANY = 4;

    private PlanText() {}

    static List<String> of(UpdatePlan.Relight plan) {
        List<String> steps = new ArrayList<>();
        for (String name : plan.top().dropped()) {
            steps.add(Texts.of("{0}: delete", name));
        }
        describe(plan.top().layers(), steps);
        steps.addAll(plan.top().materials().steps());
        if (!plan.shapes().isEmpty()) {
            steps.add(Texts.of("shapes"));
        }
        if (plan.depthTo() != plan.depthFrom()) {
            steps.add(Texts.of("depth {0} → {1}", plan.depthFrom(), plan.depthTo()));
        }
        if (plan.resampled()) {
            steps.add(Texts.of("samples"));
        }
        if (plan.mirrors() != null && plan.depthTo() > 0 && plan.mirrors().materials().materials().reflectiveCount() > 0) {
            steps.add(Texts.of("reflections"));
        }
        if (steps.isEmpty()) {
            steps.add(Texts.of("compose"));
        }
        return steps;
    }

    /** Many lights in a row of which the same is done, as those of an environment, are one step. */
    private static void describe(List<LayerPlan> layers, List<String> steps) {
        int end = 0;
        for (int i = 0; i < layers.size(); i = end) {
            String what = words(layers.get(i).update());
            end = i + 1;
            while (end < layers.size() && words(layers.get(end).update()).equals(what)) {
                end++;
            }
            if (end - i >= MANY && !what.isEmpty()) {
                steps.add(Texts.of("{0} to {1}: {2}", layers.get(i).light().name(), layers.get(end - 1).light().name(), what));
            } else if (!what.isEmpty()) {
                layers.subList(i, end).forEach(layer -> steps.add(layer.light().name() + ": " + what));
            }
        }
    }

    /** What is done to a light's layer; empty for nothing. */
    private static String words(LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _ -> "";
            case LightUpdate.Reweight _ -> Texts.of("weight");
            case LightUpdate.Refresh _ -> Texts.of("refresh");
            case LightUpdate.FullRecompute full -> full.added() ? Texts.of("add") : Texts.of("full recompute");
            case LightUpdate.Partial partial -> {
                List<String> parts = new ArrayList<>();
                switch (partial.cone()) {
                    case NONE -> {}
                    case ANGLE_REMOVE -> parts.add(Texts.of("angle remove"));
                    case ANGLE_ADD -> parts.add(Texts.of("angle add"));
                    case LINKS -> parts.add(Texts.of("links"));
                    case TURN -> parts.add(Texts.of("turn"));
                }
                if (partial.falloff()) {
                    parts.add(Texts.of("falloff"));
                }
                if (partial.shadows()) {
                    parts.add(Texts.of("shadows"));
                }
                if (partial.weight()) {
                    parts.add(Texts.of("weight"));
                }
                yield String.join(" + ", parts);
            }
        };
    }
}
