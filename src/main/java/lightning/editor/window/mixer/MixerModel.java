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
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.MixerChannel;
import lightning.editor.document.MixerEdits;
import lightning.editor.window.command.ForcedLiveUpdate;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * What the strips of the mixer have in common: which are selected, whether an edit of several is relative, and the edits. An
 * edit is shown in the traced picture at once, with or without Live.
 */
final class MixerModel {
    private final SceneEditor editor;
    private final BooleanProperty relative = new SimpleBooleanProperty(true);
    private final ReadOnlyObjectWrapper<Set<MixerChannel>> selected = new ReadOnlyObjectWrapper<>(Set.of());
    private MixerChannel anchor;
    /** The scene before the drag that goes on; null while none does. */
    private Scene sceneBeforeDrag;

    MixerModel(SceneEditor editor) {
        this.editor = editor;
    }

    SceneEditor editor() {
        return editor;
    }

    /** Whether an edit of several strips keeps their ratios; else all get the same value. */
    BooleanProperty relativeProperty() {
        return relative;
    }

    ReadOnlyObjectProperty<Set<MixerChannel>> selectedProperty() {
        return selected.getReadOnlyProperty();
    }

    boolean isSelected(MixerChannel channel) {
        return selected.get().contains(channel);
    }

    /** Selects one alone; in the editor too, where it is a light. */
    void select(MixerChannel channel) {
        anchor = channel;
        setSelected(List.of(channel));
    }

    /** Adds one to those that are selected, or takes it from them. */
    void toggle(MixerChannel channel) {
        Set<MixerChannel> channels = new LinkedHashSet<>(selected.get());
        if (!channels.remove(channel)) {
            channels.add(channel);
        }
        anchor = channel;
        setSelected(channels);
    }

    /** Selects all from the one selected last to this one. */
    void selectRange(MixerChannel channel, List<MixerChannel> shown) {
        int from = Math.max(0, shown.indexOf(anchor));
        int to = shown.indexOf(channel);
        setSelected(shown.subList(Math.min(from, to), Math.max(from, to) + 1));
    }

    /** Selects these alone. */
    void setSelected(Iterable<MixerChannel> channels) {
        Set<MixerChannel> newSelection = new LinkedHashSet<>();
        channels.forEach(newSelection::add);
        selected.set(newSelection);
        if (newSelection.size() == 1 && newSelection.iterator().next() instanceof MixerChannel.OfLight(String name)) {
            editor.selection().selectLight(name);
        }
    }

    /** Another light is selected in the editor: it alone here too, unless several are. */
    void followSelection(Light light) {
        if (selected.get().size() <= 1) {
            selected.set(Set.of(new MixerChannel.OfLight(light.name())));
        }
    }

    /** Those that an edit of a strip's is of: all selected ones where it is among them; else it is selected alone. */
    private Set<MixerChannel> editedChannels(MixerChannel channel) {
        if (!isSelected(channel)) {
            select(channel);
        }
        return selected.get();
    }

    /** A drag begins: relative edits go from what is there now. */
    void beginDrag(MixerChannel channel) {
        editedChannels(channel);
        sceneBeforeDrag = editor.scene();
    }

    /** As {@link #beginDrag(MixerChannel)}, of all. */
    void beginDrag() {
        sceneBeforeDrag = editor.scene();
    }

    void endDrag() {
        sceneBeforeDrag = null;
    }

    private Scene baseScene() {
        return sceneBeforeDrag == null ? editor.scene() : sceneBeforeDrag;
    }

    /** Sets the intensity of a strip, and that of the others selected with it: relative or the same. */
    Optional<String> setIntensity(MixerChannel channel, double intensity, Object gesture) {
        Set<MixerChannel> channels = editedChannels(channel);
        Scene from = baseScene();
        double oldIntensity = channel.intensity(from);
        if (!relative.get() || channels.size() == 1) {
            return edit(scene -> MixerEdits.setIntensity(scene, channels, intensity), gesture);
        }
        if (oldIntensity == 0) {
            return report(
                    Optional.of(Messages.tr("{0} is at 0, so it cannot be scaled. Choose Absolute, or drag another strip",
                            channel.title())));
        }
        return edit(scene -> MixerEdits.scaleIntensity(scene, from, channels, intensity / oldIntensity), gesture);
    }

    /** Makes everything brighter by so many stops. */
    Optional<String> setMaster(double stops, Object gesture) {
        Scene from = baseScene();
        return edit(scene -> MixerEdits.scaleAll(scene, from, Math.pow(2, stops)), gesture);
    }

    /** Any edit of a strip and of the others selected with it. */
    Optional<String> editSelected(MixerChannel channel, BiFunction<Scene, MixerChannel, Scene> edit, Object gesture) {
        Set<MixerChannel> channels = editedChannels(channel);
        return edit(scene -> MixerEdits.editEach(scene, channels, edit), gesture);
    }

    /** Any edit; it is in the traced picture as soon as that can be. */
    Optional<String> edit(Function<Scene, EditOutcome> edit, Object gesture) {
        Optional<String> refusal = editor.editOrReport(edit, gesture);
        if (refusal.isEmpty()) {
            ForcedLiveUpdate.render(editor);
        }
        return refusal;
    }

    /** Says why a text is no value; nothing for an empty reason. */
    void reportRefusal(String refusal) {
        report(Optional.of(refusal).filter(reason -> !reason.isEmpty()));
    }

    private Optional<String> report(Optional<String> refusal) {
        refusal.ifPresent(editor.message()::show);
        return refusal;
    }
}
