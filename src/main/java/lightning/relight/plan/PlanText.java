package lightning.relight.plan;

import java.util.ArrayList;
import java.util.List;

/** Puts a plan into words. */
final class PlanText {
    private PlanText() {}

    static List<String> of(UpdatePlan.Relight plan) {
        List<String> steps = new ArrayList<>();
        for (String name : plan.top().dropped()) {
            steps.add(name + ": delete");
        }
        for (LayerPlan layer : plan.top().layers()) {
            describe(layer, steps);
        }
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

    private static void describe(LayerPlan layer, List<String> steps) {
        String name = layer.light().name() + ": ";
        switch (layer.update()) {
            case LightUpdate.Keep _ -> {}
            case LightUpdate.Reweight _ -> steps.add(name + "weight");
            case LightUpdate.Refresh _ -> steps.add(name + "refresh");
            case LightUpdate.FullRecompute full -> steps.add(name + (full.added() ? "add" : "full recompute"));
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
                steps.add(name + String.join(" + ", parts));
            }
        }
    }
}
