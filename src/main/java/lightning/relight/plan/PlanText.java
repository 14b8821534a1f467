package lightning.relight.plan;

import java.util.ArrayList;
import java.util.List;

/** Puts a plan into words. */
final class PlanText {
    /** So many lights are told by the first and the last. */
    private static final int MANY = 4;

    private PlanText() {}

    static List<String> of(UpdatePlan.Relight plan) {
        List<String> steps = new ArrayList<>();
        for (String name : plan.top().dropped()) {
            steps.add(name + ": delete");
        }
        describe(plan.top().layers(), steps);
        steps.addAll(plan.top().materials().steps());
        if (!plan.shapes().isEmpty()) {
            steps.add("shapes");
        }
        if (plan.depthTo() != plan.depthFrom()) {
            steps.add("depth " + plan.depthFrom() + " → " + plan.depthTo());
        }
        if (plan.resampled()) {
            steps.add("samples");
        }
        if (plan.mirrors() != null && plan.depthTo() > 0 && plan.mirrors().materials().materials().reflectiveCount() > 0) {
            steps.add("reflections");
        }
        if (steps.isEmpty()) {
            steps.add("compose");
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
                steps.add(layers.get(i).light().name() + " to " + layers.get(end - 1).light().name() + ": " + what);
            } else if (!what.isEmpty()) {
                layers.subList(i, end).forEach(layer -> steps.add(layer.light().name() + ": " + what));
            }
        }
    }

    /** What is done to a light's layer; empty for nothing. */
    private static String words(LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _ -> "";
            case LightUpdate.Reweight _ -> "weight";
            case LightUpdate.Refresh _ -> "refresh";
            case LightUpdate.FullRecompute full -> full.added() ? "add" : "full recompute";
            case LightUpdate.Partial partial -> {
                List<String> parts = new ArrayList<>();
                switch (partial.cone()) {
                    case NONE -> {}
                    case ANGLE_REMOVE -> parts.add("angle remove");
                    case ANGLE_ADD -> parts.add("angle add");
                    case LINKS -> parts.add("links");
                    case TURN -> parts.add("turn");
                }
                if (partial.falloff()) {
                    parts.add("falloff");
                }
                if (partial.shadows()) {
                    parts.add("shadows");
                }
                if (partial.weight()) {
                    parts.add("weight");
                }
                yield String.join(" + ", parts);
            }
        };
    }
}
