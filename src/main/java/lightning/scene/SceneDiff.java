package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightMatcher;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.BlockList;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.SceneLimits;

/** Description of the changes between two scenes: {@code key: intensity 1 → 1.2}. */
public final class SceneDiff {
    /** Above this many nodes, changes are not described. */
    private static final int MAX_NODES = 3;

    private final boolean brief;
    private final List<String> parts = new ArrayList<>();

    /** Change of one attribute, for the user. */
    private record Change(String title, String before, String after) {
        boolean isVisible() {
            return !before.equals(after);
        }

        String name() {
            return Messages.tr(title);
        }

        String text() {
            return name() + " " + before + " → " + after;
        }
    }

    private SceneDiff(boolean brief) {
        this.brief = brief;
    }

    /**
     * Describes all changes for benchmarks, with the attributes' stable ids: {@code key: color 1 1 1 → 1 0 0, angle 30 → 20}. Never empty.
     */
    public static String describe(Scene before, Scene after) {
        return new SceneDiff(false).describeChanges(before, after);
    }

    /**
     * Summarizes the changes for a menu: {@code key: color, intensity} if several attributes of a light or material changed. Never empty.
     */
    public static String summarize(Scene before, Scene after) {
        return new SceneDiff(true).describeChanges(before, after);
    }

    /** Summarizes the edit of one light for a menu. */
    public static String summarize(Light before, Light after) {
        return new SceneDiff(true).describeChanges(before, after);
    }

    private String describeChanges(Scene before, Scene after) {
        addLights(new LightMatcher(before.lights(), after.lights()));
        addNamed(before.rig().lightGroups(), after.rig().lightGroups(), LightGroup::name, LightGroup.ATTRIBUTES,
                Messages.key("order of light groups"));
        for (SceneAttribute<World, ?> attribute : World.ATTRIBUTES) {
            change(attribute, before.world(), after.world()).ifPresent(this::addPart);
        }
        addNamed(before.world().named(), after.world().named(), Dome::name, Dome.ATTRIBUTES, Messages.key("order of domes"));
        addNamed(before.cameras(), after.cameras(), NamedCamera::name, NamedCamera.ATTRIBUTES, Messages.key("order of cameras"));
        for (SceneAttribute<Camera, ?> attribute : LensAttributes.ALL) {
            change(attribute, before.camera(), after.camera()).ifPresent(this::addPart);
        }
        if (!before.picture().equals(after.picture())) {
            change(PictureSettings.DEPTH, before.picture(), after.picture()).ifPresent(this::addPart);
            change(PictureSettings.REFLECTION_RAYS, before.picture(), after.picture()).ifPresent(this::addPart);
            addPart(new Change(Messages.key("anti-aliasing"), sampling(before), sampling(after)));
            addIndirect(before.picture().indirect(), after.picture().indirect());
            addPart(new Change(Messages.key("size"), size(before), size(after)));
            addView(before.picture().view(), after.picture().view());
        }
        boolean describable = addMaterials(before, after) & addNodes(before, after);
        boolean hasOtherChanges = !describable || !before.withPicture(after.picture())
                .withCamera(before.camera().withLens(after.camera().lens())).hasSameView(after);
        if (hasOtherChanges || parts.isEmpty()) {
            parts.add(Messages.tr("the scene"));
        }
        return String.join(", ", parts);
    }

    private void addPart(Change change) {
        if (change.isVisible()) {
            parts.add(change.text());
        }
    }

    private void addLights(LightMatcher match) {
        match.removedIndices().forEach(i -> parts.add(Messages.tr("delete {0}", match.before().get(i).name())));
        boolean ordered = true;
        int last = -1;
        for (int i = 0; i < match.after().size(); i++) {
            Light after = match.after().get(i);
            int origin = match.originIndex(i);
            if (origin < 0) {
                parts.add(Messages.tr("add {0}", after.name()) + (brief ? "" : ", " + LightAttribute.TYPE.format(after)));
            } else if (!match.before().get(origin).equals(after)) {
                parts.add(describeChanges(match.before().get(origin), after));
            }
            ordered &= origin < 0 || origin > last;
            last = Math.max(last, origin);
        }
        if (!ordered) {
            parts.add(Messages.tr("order of lights"));
        }
    }

    /** Matches light groups or domes by name, or by index if their number is unchanged. */
    private <T> void addNamed(List<T> before, List<T> after, Function<T, String> name, List<? extends SceneAttribute<T, ?>> attributes,
            String order) {
        boolean renames = before.size() == after.size();
        Map<String, T> old = before.stream().collect(Collectors.toMap(name, v -> v));
        Map<String, T> current = after.stream().collect(Collectors.toMap(name, v -> v));
        for (T v : before) {
            if (!renames && !current.containsKey(name.apply(v))) {
                parts.add(Messages.tr("delete {0}", name.apply(v)));
            }
        }
        for (int i = 0; i < after.size(); i++) {
            T v = after.get(i);
            T origin = old.getOrDefault(name.apply(v), renames ? before.get(i) : null);
            if (origin == null) {
                parts.add(Messages.tr("add {0}", name.apply(v)));
            } else if (!origin.equals(v)) {
                List<Change> changes = new ArrayList<>(List.of(new Change(Messages.key("name"), name.apply(origin), name.apply(v))));
                changes.addAll(changes(attributes, origin, v));
                parts.add(join(name.apply(origin), changes));
            }
        }
        if (!names(before, name, current).equals(names(after, name, old))) {
            parts.add(Messages.tr(order));
        }
    }

    private static <T> List<String> names(List<T> all, Function<T, String> name, Map<String, T> among) {
        return all.stream().map(name).filter(among::containsKey).toList();
    }

    private String describeChanges(Light before, Light after) {
        List<Change> changes = new ArrayList<>(List.of(new Change(Messages.key("name"), before.name(), after.name())));
        changes.addAll(changes(LightAttribute.ALL, before, after));
        return join(before.name(), changes);
    }

    /** Adds the changes of each material; returns false if more than attribute values changed. */
    private boolean addMaterials(Scene before, Scene after) {
        if (before.materials().equals(after.materials())) {
            return true;
        }
        Map<String, Material> previous = before.materialsByName();
        for (Material material : after.materials()) {
            Material old = previous.get(material.name());
            if (old != null && !old.equals(material.withBulb(material.bulb().withGlow(old.bulb().glow()).withUnit(old.bulb().unit())))) {
                // Attributes that only one of the models has are not described.
                parts.add(join(old.name(), changes(MaterialAttribute.ALL.stream()
                        .filter(a -> a.appliesTo(old.model()) && a.appliesTo(material.model())).toList(), old, material)));
            }
        }
        return names(after).equals(names(before)) || addsDefault(before, after);
    }

    /** Adds the changes of each shape and group; returns false if more than attribute values changed, or too many nodes. */
    private boolean addNodes(Scene before, Scene after) {
        List<String> changed = new ArrayList<>();
        if (!addNodes(before.nodes(), after.nodes(), changed) || changed.size() > MAX_NODES) {
            return false;
        }
        parts.addAll(changed);
        return true;
    }

    /** Skips a common prefix and suffix; the nodes between were added, removed, or edited in place. */
    private boolean addNodes(List<SceneNode> before, List<SceneNode> after, List<String> changed) {
        int begin = BlockList.sharedStart(before, after);
        int shared = Math.min(BlockList.sharedEnd(before, after), Math.min(before.size(), after.size()) - begin);
        int end = before.size() - shared;
        int endAfter = after.size() - shared;
        while (begin < Math.min(end, endAfter) && same(before.get(begin), after.get(begin))) {
            begin++;
        }
        while (Math.min(end, endAfter) > begin && same(before.get(end - 1), after.get(endAfter - 1))) {
            end--;
            endAfter--;
        }
        boolean describable = begin == end || begin == endAfter || end == endAfter;
        for (int i = begin; describable && i < Math.max(end, endAfter) && changed.size() <= MAX_NODES; i++) {
            if (end == endAfter) {
                describable = addNode(before.get(i), after.get(i), changed);
            } else {
                changed.add(i < endAfter ? Messages.tr("add {0}", after.get(i).name()) : Messages.tr("delete {0}", before.get(i).name()));
            }
        }
        return describable;
    }

    /** Tests identity first, because almost all of very many nodes are identical. */
    private static boolean same(SceneNode a, SceneNode b) {
        return a == b || a.equals(b);
    }

    private boolean addNode(SceneNode a, SceneNode b, List<String> changed) {
        if (a instanceof NodeGroup != b instanceof NodeGroup || !solid(a).equals(solid(b))) {
            return false;
        }
        List<Change> changes = changes(a, b);
        if (!changes.isEmpty()) {
            changed.add(join(a.name(), changes));
        }
        return !(a instanceof NodeGroup g && b instanceof NodeGroup h) || addNodes(g.children(), h.children(), changed);
    }

    private static Optional<Solid> solid(SceneNode node) {
        return node instanceof Shape s ? Optional.of(s.solid()) : Optional.empty();
    }

    private static List<Change> changes(SceneNode a, SceneNode b) {
        List<Change> changes = new ArrayList<>();
        if (!a.name().equals(b.name())) {
            changes.add(new Change(Messages.key("name"), a.name(), b.name()));
        }
        if (a instanceof Shape s && b instanceof Shape t && !s.material().equals(t.material())) {
            changes.add(new Change(Messages.key("material"), s.material(), t.material()));
        }
        change(Messages.key("position"), a.placement().position(), b.placement().position(), changes);
        change(Messages.key("rotation"), a.placement().rotation(), b.placement().rotation(), changes);
        change(Messages.key("scale"), a.placement().scale(), b.placement().scale(), changes);
        if (a.visible() != b.visible()) {
            changes.add(new Change(Messages.key("visible"), a.visible() ? "yes" : "no", b.visible() ? "yes" : "no"));
        }
        return changes;
    }

    private static void change(String title, Vec3 a, Vec3 b, List<Change> changes) {
        if (!a.equals(b)) {
            changes.add(new Change(title, format(a), format(b)));
        }
    }

    private static String format(Vec3 v) {
        return SceneLimits.formatShort(v.x()) + " " + SceneLimits.formatShort(v.y()) + " " + SceneLimits.formatShort(v.z());
    }

    private static boolean addsDefault(Scene before, Scene after) {
        List<String> names = new ArrayList<>(names(before));
        names.add(Material.DEFAULT.name());
        return names(after).equals(names);
    }

    private static List<String> names(Scene scene) {
        return scene.materials().stream().map(Material::name).toList();
    }

    private <T> List<Change> changes(List<? extends SceneAttribute<T, ?>> attributes, T before, T after) {
        List<Change> changes = new ArrayList<>();
        attributes.forEach(a -> change(a, before, after).ifPresent(changes::add));
        return changes;
    }

    /** Returns empty for an unchanged value, before formatting its numbers. */
    private <T> Optional<Change> change(SceneAttribute<T, ?> attribute, T before, T after) {
        return attribute.get(before).equals(attribute.get(after)) ? Optional.empty()
                : Optional.of(new Change(brief ? attribute.title() : attribute.id(), attribute.format(before), attribute.format(after)));
    }

    private String join(String name, List<Change> candidates) {
        List<Change> changes = candidates.stream().filter(Change::isVisible).toList();
        return name + ": " + (changes.isEmpty() ? Messages.tr("small change")
                : changes.stream().map(brief && changes.size() > 1 ? Change::name : Change::text).collect(Collectors.joining(", ")));
    }

    private static String size(Scene scene) {
        return scene.picture().width() + " × " + scene.picture().height();
    }

    /** Adds the changed settings, or all of them if indirect light was switched on or off. */
    private void addIndirect(Optional<IndirectSettings> before, Optional<IndirectSettings> after) {
        if (before.isPresent() && after.isPresent()) {
            changes(IndirectSettings.ATTRIBUTES, before.get(), after.get()).forEach(this::addPart);
        } else {
            addPart(new Change(Messages.key("indirect light"), indirect(before), indirect(after)));
        }
    }

    private void addView(ViewSettings before, ViewSettings after) {
        addPart(new Change(Messages.key("view transform"), before.curve().word(), after.curve().word()));
        addPart(new Change(Messages.key("view exposure"), SceneLimits.formatShort(before.exposure()),
                SceneLimits.formatShort(after.exposure())));
    }

    private static String indirect(Optional<IndirectSettings> settings) {
        return settings.map(IndirectSettings::label).orElse("off");
    }

    private static String sampling(Scene scene) {
        SamplingSettings sampling = scene.picture().sampling();
        return sampling.antialias().name().toLowerCase(Locale.ROOT) + " " + sampling.grid() + " × " + sampling.grid();
    }
}
