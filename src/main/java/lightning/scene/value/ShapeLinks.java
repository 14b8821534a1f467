package lightning.scene.value;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.Stage;
import lightning.scene.light.Light;

/**
 * Light linking: only the named shapes, or all except them. The name of a group stands for all its shapes. {@link Stage#linkMask} resolves
 * the links.
 *
 * @param exclusive true for only the named shapes, false for all others
 * @param names     unique names of shapes and groups; names that the scene does not have are ignored
 */
public record ShapeLinks(boolean exclusive, List<String> names) {
    /** All shapes. */
    public static final ShapeLinks ALL = new ShapeLinks(false, List.of());
    /** No shape. */
    public static final ShapeLinks NONE = new ShapeLinks(true, List.of());

    /** @throws IllegalArgumentException if a name is invalid, or if there are more than {@link SceneLimits#MAX_LINKS} */
    public ShapeLinks {
        names = List.copyOf(new LinkedHashSet<>(names));
        SceneLimits.checkRange("the number of linked objects", names.size(), 0, SceneLimits.MAX_LINKS);
        names.forEach(SceneLimits::checkName);
    }

    public static ShapeLinks only(String... names) {
        return new ShapeLinks(true, List.of(names));
    }

    public static ShapeLinks except(String... names) {
        return new ShapeLinks(false, List.of(names));
    }

    /** Returns whether all shapes are linked. */
    public boolean isAll() {
        return !exclusive && names.isEmpty();
    }

    /** Returns these links with a shape or a group renamed. */
    public ShapeLinks rename(String oldName, String newName) {
        return !names.contains(oldName) ? this
                : new ShapeLinks(exclusive, names.stream().map(n -> n.equals(oldName) ? newName : n).toList());
    }

    /** Returns these links without unknown names. */
    public ShapeLinks retain(Predicate<String> exists) {
        return names.stream().allMatch(exists) ? this : new ShapeLinks(exclusive, names.stream().filter(exists).toList());
    }

    /** Returns these links with a name added at the end, or removed. */
    public ShapeLinks with(String name, boolean linked) {
        List<String> newNames = new ArrayList<>(names);
        newNames.remove(name);
        if (linked) {
            newNames.add(name);
        }
        return new ShapeLinks(exclusive, newNames);
    }

    /** Formats for the user: {@code all}, {@code none}, {@code only a, b} or {@code all except a, b}. */
    public String format() {
        String list = names.stream().map(Quote::of).collect(Collectors.joining(", "));
        return isAll() ? Messages.tr("all") : equals(NONE) ? Messages.tr("none") : exclusive ? Messages.tr("only {0}", list)
                : Messages.tr("all except {0}", list);
    }
}
