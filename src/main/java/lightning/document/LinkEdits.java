package lightning.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import lightning.base.text.Messages;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;

/** Edits of the link between one light and one shape or group: illumination and shadow on or off, and gain. */
public final class LinkEdits {
    private LinkEdits() {}

    /**
     * Links a shape, or all shapes of a group, or unlinks it; all other shapes stay as they are.
     *
     * @param attribute what the link is for: illumination or shadow
     */
    public static EditOutcome link(Scene scene, String light, LightAttribute<ShapeLinks> attribute, String node, boolean linked) {
        return LightEdits.edit(scene, light, l -> attribute.with(l, linked(attribute.get(l), scene.stage(), node, linked)))
                .named(linked ? Messages.tr("Link {0} to {1}", light, node) : Messages.tr("Unlink {0} from {1}", light, node));
    }

    /** Returns whether links contain a shape, by its own name or that of a group around it. */
    public static boolean isLinked(Stage stage, ShapeLinks links, String shape) {
        return links.exclusive() == LinkTable.path(stage, shape).stream().anyMatch(links.names()::contains);
    }

    /**
     * Sets the gain of a light on a shape or group. An object without any link is linked.
     *
     * @param keep true to store a gain that the object would have anyway, as during a drag
     */
    public static EditOutcome setGain(Scene scene, String light, String node, double gain, boolean keep) {
        return LightEdits.edit(scene, light, l -> {
            ShapeGains others = l.influence().gains().without(node);
            boolean isRedundant = !keep && LinkTable.gain(others, LinkTable.path(scene.stage(), node)) == gain;
            Light gained = withGains(l, isRedundant ? others : l.influence().gains().with(node, gain));
            return isLinked(l, scene.stage(), node) ? gained
                    : gained.withIlluminates(linked(l.illuminates(), scene.stage(), node, true));
        }).named(Messages.tr("Gain of {0} on {1}", light, node));
    }

    /** Returns whether a light illuminates a shape, or anything in a group. */
    private static boolean isLinked(Light light, Stage stage, String node) {
        return stage.node(node).map(n -> LinkTable.link(light, new LinkTable.Row(LinkTable.path(stage, node), n, false)))
                .filter(link -> link.state() != LinkTable.State.OFF).isPresent();
    }

    /** Removes the gain of a light on a shape or group, and on all objects in the group. */
    public static EditOutcome resetGain(Scene scene, String light, String node) {
        return LightEdits.edit(scene, light, l -> {
            Set<String> inside = scene.stage().node(node).map(n -> addNames(n, new HashSet<>())).orElse(Set.of());
            return withGains(l, l.influence().gains().retain(name -> !inside.contains(name)));
        }).named(Messages.tr("Reset gain of {0} on {1}", light, node));
    }

    private static Light withGains(Light light, ShapeGains gains) {
        Influence influence = light.influence();
        return light.withInfluence(influence.withGains(gains));
    }

    private static Set<String> addNames(SceneNode node, Set<String> names) {
        names.add(node.name());
        if (node instanceof NodeGroup group) {
            group.children().forEach(child -> addNames(child, names));
        }
        return names;
    }

    /** Returns links with those of one node changed. If one of its groups is named, the rest of the group is named instead. */
    static ShapeLinks linked(ShapeLinks links, Stage stage, String node, boolean linked) {
        boolean named = linked == links.exclusive();
        List<NodeGroup> groups = stage.enclosingGroups(node);
        Set<String> inside = stage.node(node).map(n -> addNames(n, new HashSet<>())).orElse(Set.of());
        int outermost = 0;
        while (outermost < groups.size() && !links.names().contains(groups.get(outermost).name())) {
            outermost++;
        }
        boolean inNamedGroup = outermost < groups.size();
        if (named && inNamedGroup) {
            return links;
        }
        List<String> names = new ArrayList<>(links.names().stream().filter(name -> !inside.contains(name)).toList());
        if (named) {
            names.add(node);
        }
        for (int g = outermost; g < groups.size(); g++) {
            // Objects in the outermost named group are all named, whether or not they are named themselves.
            NodeGroup group = groups.get(g);
            String next = g + 1 < groups.size() ? groups.get(g + 1).name() : node;
            names.remove(group.name());
            group.children().stream().map(SceneNode::name).filter(name -> !name.equals(next) && !names.contains(name)).forEach(names::add);
        }
        return new ShapeLinks(links.exclusive(), names);
    }
}
