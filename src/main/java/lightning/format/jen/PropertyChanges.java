package lightning.format.jen;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;

/** Changes of lights, light groups, the world and domes as edits in words: the opposite of {@link PropertyEdit}. */
public final class PropertyChanges {
    private PropertyChanges() {}

    /**
     * Returns the edits that make the lights, light groups, world and domes of one scene those of another, in file order.
     *
     * @param folder folder that images are resolved against
     * @return empty if words cannot say it: lights or domes were added or deleted
     */
    public static Optional<List<String>> between(Scene before, Scene after, Path folder) {
        List<String> edits = new ArrayList<>();
        Stream.of(SceneElement.named(after).filter(e -> e instanceof SceneElement.OfLight || e instanceof SceneElement.OfLightGroup),
                Stream.of(SceneElement.WORLD), SceneElement.named(after).filter(SceneElement.OfDome.class::isInstance))
                .flatMap(elements -> elements).filter(element -> element.existsIn(before))
                .forEach(element -> add(element, before, after, edits));
        return makes(edits, before, after, folder) ? Optional.of(edits) : Optional.empty();
    }

    private static void add(SceneElement<?> element, Scene before, Scene after, List<String> edits) {
        BlockContent old = BlockContent.of(before, element);
        BlockContent current = BlockContent.of(after, element);
        for (String property : current.values().keySet()) {
            String value = PropertyEdit.text(current, property);
            if (!value.equals(PropertyEdit.text(old, property))) {
                edits.add(PropertyEdit.target(element) + "." + property + "=" + value);
            }
        }
    }

    private static boolean makes(List<String> edits, Scene before, Scene after, Path folder) {
        Scene edited = before;
        try {
            for (String edit : edits) {
                edited = PropertyEdit.apply(edited, edit, folder);
            }
        } catch (RefusalException e) {
            return false;
        }
        return edited.rig().equals(after.rig()) && edited.world().equals(after.world());
    }

    /** Returns edits after others, without those that a later edit of the same property replaces. */
    public static List<String> joined(List<String> first, List<String> then) {
        List<String> replaced = then.stream().map(PropertyChanges::property).toList();
        return Stream.concat(first.stream().filter(edit -> !replaced.contains(property(edit))), then.stream()).toList();
    }

    private static String property(String edit) {
        PropertyEdit.Assignment parts = PropertyEdit.Assignment.of(edit);
        return parts.target() + "." + parts.property();
    }
}
