package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Messages;

/** Text description of a plan for status bar and reports. */
final class PlanDescription {
    /** At least this many lights with the same update are described as a range. */
    private static final int MIN_GROUP_SIZE = 4;

    private PlanDescription() {}

    static List<String> steps(UpdatePlan.Relight plan) {
        List<String> steps = new ArrayList<>();
        for (String name : plan.top().droppedLights()) {
            steps.add(Messages.tr("{0}: delete", name));
        }
        addLayerSteps(plan.top().layers(), steps);
        steps.addAll(plan.top().materials().describe());
        if (!plan.shapes().isEmpty()) {
            steps.add(Messages.tr("shapes"));
        }
        if (plan.newDepth() != plan.oldDepth()) {
            steps.add(Messages.tr("reflection bounces {0} → {1}", plan.oldDepth(), plan.newDepth()));
        }
        if (plan.resampled()) {
            steps.add(Messages.tr("samples"));
        }
        if (plan.mirrors() != null && plan.newDepth() > 0 && plan.mirrors().materials().materials().reflectiveCount() > 0) {
            steps.add(Messages.tr("reflections"));
        }
        addPathStep(plan, steps);
        if (steps.isEmpty()) {
            steps.add(Messages.tr("compose"));
        }
        return steps;
    }

    private static void addPathStep(UpdatePlan.Relight plan, List<String> steps) {
        switch (plan.paths()) {
            case NONE -> {}
            case KEEP -> {
                if (plan.top().layers().stream().anyMatch(LayerPlan::changesImage) || !plan.top().droppedLights().isEmpty()
                        || !plan.top().materials().isEmpty()) {
                    steps.add(Messages.tr("gathered light"));
                }
            }
            case REPEAT -> steps.add(Messages.tr("gathered light: changed paths"));
            case BUILD -> steps.add(Messages.tr("gathered light: all paths"));
        }
    }

    /** Combines many consecutive lights with the same update, such as those of an environment, into one step. */
    private static void addLayerSteps(List<LayerPlan> layers, List<String> steps) {
        int end = 0;
        for (int i = 0; i < layers.size(); i = end) {
            String description = describe(layers.get(i).update());
            end = i + 1;
            while (end < layers.size() && describe(layers.get(end).update()).equals(description)) {
                end++;
            }
            if (end - i >= MIN_GROUP_SIZE && !description.isEmpty()) {
                steps.add(Messages.tr("{0} to {1}: {2}", layers.get(i).light().name(), layers.get(end - 1).light().name(), description));
            } else if (!description.isEmpty()) {
                layers.subList(i, end).forEach(layer -> steps.add(layer.light().name() + ": " + description));
            }
        }
    }

    /** Returns the description of a light's update; empty for none. */
    private static String describe(LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _ -> "";
            case LightUpdate.Reweight _ -> Messages.tr("weight");
            case LightUpdate.Refresh _ -> Messages.tr("refresh");
            case LightUpdate.FullRecompute full -> full.added() ? Messages.tr("add") : Messages.tr("full recompute");
            case LightUpdate.Partial partial -> {
                List<String> parts = new ArrayList<>();
                switch (partial.cone()) {
                    case NONE -> {}
                    case ANGLE_REMOVE -> parts.add(Messages.tr("angle remove"));
                    case ANGLE_ADD -> parts.add(Messages.tr("angle add"));
                    case LINKS -> parts.add(Messages.tr("links"));
                    case TURN -> parts.add(Messages.tr("turn"));
                }
                if (partial.falloff()) {
                    parts.add(Messages.tr("falloff"));
                }
                if (partial.shadows()) {
                    parts.add(Messages.tr("shadows"));
                }
                if (partial.weight()) {
                    parts.add(Messages.tr("weight"));
                }
                yield String.join(" + ", parts);
            }
        };
    }
}
