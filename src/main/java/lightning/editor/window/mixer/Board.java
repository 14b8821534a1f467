package lightning.editor.window.mixer;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Channel;
import lightning.editor.document.ChannelEdits;
import lightning.editor.window.command.AtOnce;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * What the strips of the mixer have in common: which are selected, whether an edit of several is relative, and the edits. An
 * edit is shown in the traced picture at once, with or without Live.
 */
final class Board {
    private final SceneEditor editor;
    private final BooleanProperty relative = new SimpleBooleanProperty(true);
    private final ReadOnlyObjectWrapper<Set<Channel>> selected = new ReadOnlyObjectWrapper<>(Set.of());
    private Channel anchor;
    /** The scene before the drag that goes on; null while none does. */
    private Scene base;

    Board(SceneEditor editor) {
        this.editor = editor;
    }

    SceneEditor editor() {
        return editor;
    }

    /** Whether an edit of several strips keeps their ratios; else all get the same value. */
    BooleanProperty relativeProperty() {
        return relative;
    }

    ReadOnlyObjectProperty<Set<Channel>> selectedProperty() {
        return selected.getReadOnlyProperty();
    }

    boolean isSelected(Channel channel) {
        return selected.get().contains(channel);
    }

    /** Selects one alone; in the editor too, where it is a light. */
    void select(Channel channel) {
        anchor = channel;
        set(List.of(channel));
    }

    /** Adds one to those that are selected, or takes it from them. */
    void toggle(Channel channel) {
        Set<Channel> now = new LinkedHashSet<>(selected.get());
        if (!now.remove(channel)) {
            now.add(channel);
        }
        anchor = channel;
        set(now);
    }

    /** Selects all from the one selected last to this one. */
    void selectTo(Channel channel, List<Channel> shown) {
        int from = Math.max(0, shown.indexOf(anchor));
        int to = shown.indexOf(channel);
        set(shown.subList(Math.min(from, to), Math.max(from, to) + 1));
    }

    /** Selects these alone. */
    void set(Iterable<Channel> channels) {
        Set<Channel> now = new LinkedHashSet<>();
        channels.forEach(now::add);
        selected.set(now);
        if (now.size() == 1 && now.iterator().next() instanceof Channel.OfLight(String name)) {
            editor.selection().selectLight(name);
        }
    }

    /** Another light is selected in the editor: it alone here too, unless several are. */
    void follow(Light light) {
        if (selected.get().size() <= 1) {
            selected.set(Set.of(new Channel.OfLight(light.name())));
        }
    }

    /** Those that an edit of a strip's is of: all selected ones where it is among them; else it is selected alone. */
    private Set<Channel> inHand(Channel channel) {
        if (!isSelected(channel)) {
            select(channel);
        }
        return selected.get();
    }

    /** A drag begins: relative edits go from what is there now. */
    void begin(Channel channel) {
        inHand(channel);
        base = editor.scene();
    }

    /** As {@link #begin(Channel)}, of all. */
    void begin() {
        base = editor.scene();
    }

    void end() {
        base = null;
    }

    private Scene base() {
        return base == null ? editor.scene() : base;
    }

    /** Sets the intensity of a strip, and that of the others selected with it: relative or the same. */
    Optional<String> intensity(Channel channel, double intensity, Object gesture) {
        Set<Channel> channels = inHand(channel);
        Scene from = base();
        double before = channel.intensity(from);
        if (!relative.get() || channels.size() == 1) {
            return edit(scene -> ChannelEdits.intensity(scene, channels, intensity), gesture);
        }
        if (before == 0) {
            return told(
                    Optional.of(Texts.of("{0} is dark, and no factor makes it brighter: choose Absolute, or begin at another strip",
                            channel.title())));
        }
        return edit(scene -> ChannelEdits.scaled(scene, from, channels, intensity / before), gesture);
    }

    /** Makes everything brighter by so many stops. */
    Optional<String> master(double stops, Object gesture) {
        Scene from = base();
        return edit(scene -> ChannelEdits.mastered(scene, from, Math.pow(2, stops)), gesture);
    }

    /** Any edit of a strip and of the others selected with it. */
    Optional<String> each(Channel channel, BiFunction<Scene, Channel, Scene> edit, Object gesture) {
        Set<Channel> channels = inHand(channel);
        return edit(scene -> ChannelEdits.each(scene, channels, edit), gesture);
    }

    /** Any edit; it is in the traced picture as soon as that can be. */
    Optional<String> edit(Function<Scene, Change> edit, Object gesture) {
        Optional<String> refusal = editor.editOrReport(edit, gesture);
        if (refusal.isEmpty()) {
            AtOnce.render(editor);
        }
        return refusal;
    }

    /** Says why a text is no value; nothing for an empty reason. */
    void tell(String refusal) {
        told(Optional.of(refusal).filter(reason -> !reason.isEmpty()));
    }

    private Optional<String> told(Optional<String> refusal) {
        refusal.ifPresent(editor.message()::show);
        return refusal;
    }
}
