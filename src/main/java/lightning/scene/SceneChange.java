package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;

/** Says what changed from one scene to another: {@code key: intensity 1 → 1.2}. */
public final class SceneChange {
    /** Of more shapes and groups than this it is not told what changed. */
    private static final int MOST_NODES = 3;

    private final boolean brief;
    private final List<String> parts = new ArrayList<>();

    /** One attribute with its values, for people. */
    private record Change(String title, String before, String after) {
        boolean shows() {
            return !before.equals(after);
        }

        String name() {
            return Texts.of(title);
        }

        String text() {
            return name() + " " + before + " → " + after;
        }
    }

    private SceneChange(boolean brief) {
        this.brief = brief;
    }

    /** All of it: {@code key: color 1 1 1 → 1 0 0, intensity 1 → 0.3}. Never empty. */
    public static String text(Scene before, Scene after) {
        return new SceneChange(false).of(before, after);
    }

    /** One line for a menu: {@code key: color, intensity} where several attributes of a light or material changed. Never empty. */
    public static String summary(Scene before, Scene after) {
        return new SceneChange(true).of(before, after);
    }

    /** The edit of one light, in one line for a menu. */
    public static String summary(Light before, Light after) {
        return new SceneChange(true).of(before, after);
    }

    private String of(Scene before, Scene after) {
        lights(new LightMatch(before.lights(), after.lights()));
        banks(before.rig(), after.rig());
        for (Attribute<World, ?> attribute : World.ATTRIBUTES) {
            if (attribute != World.BACKGROUND) {
                change(attribute, before.world(), after.world()).ifPresent(this::add);
            }
        }
        if (!before.picture().equals(after.picture())) {
            change(Picture.DEPTH, before.picture(), after.picture()).ifPresent(this::add);
            add(new Change(Texts.key("anti-aliasing"), sampling(before), sampling(after)));
            add(new Change(Texts.key("size"), size(before), size(after)));
        }
        boolean known = materials(before, after) & nodes(before, after);
        boolean other = !known || !before.withPicture(after.picture()).hasSameView(after)
                || !before.world().background().equals(after.world().background());
        if (other || parts.isEmpty()) {
            parts.add(Texts.of("the scene"));
        }
        return String.join(", ", parts);
    }

    private void add(Change change) {
        if (change.shows()) {
            parts.add(change.text());
        }
    }

    private void lights(LightMatch match) {
        match.gone().forEach(i -> parts.add(Texts.of("delete {0}", match.before().get(i).name())));
        boolean ordered = true;
        int last = -1;
        for (int i = 0; i < match.after().size(); i++) {
            Light after = match.after().get(i);
            int origin = match.origin(i);
            if (origin < 0) {
                parts.add(Texts.of("add {0}", after.name()) + (brief ? "" : ", " + LightAttribute.TYPE.text(after)));
            } else if (!match.before().get(origin).equals(after)) {
                parts.add(of(match.before().get(origin), after));
            }
            ordered &= origin < 0 || origin > last;
            last = Math.max(last, origin);
        }
        if (!ordered) {
            parts.add(Texts.of("order of lights"));
        }
    }

    /** A bank goes on from the one of its name, or where their number is the same from the one at its place. */
    private void banks(Rig before, Rig after) {
        boolean renames = before.banks().size() == after.banks().size();
        for (Bank bank : before.banks()) {
            if (!renames && after.bank(bank.name()).isEmpty()) {
                parts.add(Texts.of("delete {0}", bank.name()));
            }
        }
        for (int i = 0; i < after.banks().size(); i++) {
            Bank bank = after.banks().get(i);
            Optional<Bank> old = before.bank(bank.name()).or(renames ? () -> Optional.of(before.banks().get(after.banks().indexOf(bank)))
                    : Optional::empty);
            if (old.isEmpty()) {
                parts.add(Texts.of("add {0}", bank.name()));
            } else if (!old.get().equals(bank)) {
                List<Change> changes = new ArrayList<>(List.of(new Change(Texts.key("name"), old.get().name(), bank.name())));
                changes.addAll(changes(Bank.ATTRIBUTES, old.get(), bank));
                parts.add(joined(old.get().name(), changes));
            }
        }
        if (!names(before.banks(), after).equals(names(after.banks(), before))) {
            parts.add(Texts.of("order of banks"));
        }
    }

    private static List<String> names(List<Bank> banks, Rig among) {
        return banks.stream().map(Bank::name).filter(name -> among.bank(name).isPresent()).toList();
    }

    private String of(Light before, Light after) {
        List<Change> changes = new ArrayList<>(List.of(new Change(Texts.key("name"), before.name(), after.name())));
        changes.addAll(changes(LightAttribute.ALL, before, after));
        return joined(before.name(), changes);
    }

    /** Adds what changed of each material; false if the change is more than values of theirs. */
    private boolean materials(Scene before, Scene after) {
        if (before.materials().equals(after.materials())) {
            return true;
        }
        Map<String, Material> known = before.materialsByName();
        for (Material material : after.materials()) {
            Material old = known.get(material.name());
            if (old != null && !old.equals(material)) {
                // Another model has other attributes, which is not told.
                parts.add(joined(old.name(), changes(MaterialAttribute.ALL.stream()
                        .filter(a -> a.acts(old.model()) && a.acts(material.model())).toList(), old, material)));
            }
        }
        return names(after).equals(names(before)) || addsDefault(before, after);
    }

    /** Adds what changed of each shape and group; false if the change is more than values of theirs, or of too many to tell. */
    private boolean nodes(Scene before, Scene after) {
        List<String> changed = new ArrayList<>();
        if (!nodes(before.nodes(), after.nodes(), changed) || changed.size() > MOST_NODES) {
            return false;
        }
        parts.addAll(changed);
        return true;
    }

    /** What is the same at both ends is passed over; between, nodes came, or went, or are others in the same places. */
    private boolean nodes(List<Node> from, List<Node> to, List<String> changed) {
        int begin = BlockList.sharedStart(from, to);
        int shared = Math.min(BlockList.sharedEnd(from, to), Math.min(from.size(), to.size()) - begin);
        int end = from.size() - shared;
        int endNow = to.size() - shared;
        while (begin < Math.min(end, endNow) && same(from.get(begin), to.get(begin))) {
            begin++;
        }
        while (Math.min(end, endNow) > begin && same(from.get(end - 1), to.get(endNow - 1))) {
            end--;
            endNow--;
        }
        boolean known = begin == end || begin == endNow || end == endNow;
        for (int i = begin; known && i < Math.max(end, endNow) && changed.size() <= MOST_NODES; i++) {
            if (end == endNow) {
                known = node(from.get(i), to.get(i), changed);
            } else {
                changed.add(i < endNow ? Texts.of("add {0}", to.get(i).name()) : Texts.of("delete {0}", from.get(i).name()));
            }
        }
        return known;
    }

    /** Of very many nodes all but a few are the very same. */
    private static boolean same(Node a, Node b) {
        return a == b || a.equals(b);
    }

    private boolean node(Node a, Node b, List<String> changed) {
        if (a instanceof Group != b instanceof Group || !solid(a).equals(solid(b))) {
            return false;
        }
        List<Change> changes = changes(a, b);
        if (!changes.isEmpty()) {
            changed.add(joined(a.name(), changes));
        }
        return !(a instanceof Group g && b instanceof Group h) || nodes(g.children(), h.children(), changed);
    }

    private static Optional<Solid> solid(Node node) {
        return node instanceof Shape s ? Optional.of(s.solid()) : Optional.empty();
    }

    private static List<Change> changes(Node a, Node b) {
        List<Change> changes = new ArrayList<>();
        if (!a.name().equals(b.name())) {
            changes.add(new Change(Texts.key("name"), a.name(), b.name()));
        }
        if (a instanceof Shape s && b instanceof Shape t && !s.material().equals(t.material())) {
            changes.add(new Change(Texts.key("material"), s.material(), t.material()));
        }
        change(Texts.key("at"), a.placement().at(), b.placement().at(), changes);
        change(Texts.key("rotate"), a.placement().rotate(), b.placement().rotate(), changes);
        change(Texts.key("scale"), a.placement().scale(), b.placement().scale(), changes);
        if (a.visible() != b.visible()) {
            changes.add(new Change(Texts.key("visible"), a.visible() ? "yes" : "no", b.visible() ? "yes" : "no"));
        }
        return changes;
    }

    private static void change(String title, Vec3 a, Vec3 b, List<Change> changes) {
        if (!a.equals(b)) {
            changes.add(new Change(title, text(a), text(b)));
        }
    }

    private static String text(Vec3 v) {
        return Quantity.digits(v.x()) + " " + Quantity.digits(v.y()) + " " + Quantity.digits(v.z());
    }

    private static boolean addsDefault(Scene before, Scene after) {
        List<String> names = new ArrayList<>(names(before));
        names.add(Material.DEFAULT.name());
        return names(after).equals(names);
    }

    private static List<String> names(Scene scene) {
        return scene.materials().stream().map(Material::name).toList();
    }

    private static <T> List<Change> changes(List<? extends Attribute<T, ?>> attributes, T before, T after) {
        List<Change> changes = new ArrayList<>();
        attributes.forEach(a -> change(a, before, after).ifPresent(changes::add));
        return changes;
    }

    /** Nothing for a value that is the same: to write numbers takes long. */
    private static <T> Optional<Change> change(Attribute<T, ?> attribute, T before, T after) {
        return attribute.of(before).equals(attribute.of(after)) ? Optional.empty()
                : Optional.of(new Change(attribute.title(), attribute.text(before), attribute.text(after)));
    }

    private String joined(String name, List<Change> all) {
        List<Change> changes = all.stream().filter(Change::shows).toList();
        return name + ": " + (changes.isEmpty() ? Texts.of("a little")
                : changes.stream().map(brief && changes.size() > 1 ? Change::name : Change::text).collect(Collectors.joining(", ")));
    }

    private static String size(Scene scene) {
        return scene.picture().width() + " × " + scene.picture().height();
    }

    private static String sampling(Scene scene) {
        Sampling sampling = scene.picture().sampling();
        return sampling.antialias().name().toLowerCase(Locale.ROOT) + " " + sampling.grid() + " × " + sampling.grid();
    }
}
