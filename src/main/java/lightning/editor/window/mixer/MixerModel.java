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
import lightning.document.EditOutcome;
import lightning.document.MixerChannel;
import lightning.document.MixerEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Shared state of the mixer's strips: the selection, the relative mode, and the edits. An edit is rendered immediately, with or without
 * Live.
 */
final class MixerModel {
    private final SceneEditor editor;
    private final BooleanProperty relative = new SimpleBooleanProperty(true);
    private final ReadOnlyObjectWrapper<Set<MixerChannel>> selected = new ReadOnlyObjectWrapper<>(Set.of());
    private @Nullable MixerChannel anchor;
    /** Environment's light gain before it was muted. */
    private double environmentGain = 1;
    /** Scene before the current drag; null without a drag. */
    private @Nullable Scene sceneBeforeDrag;

    MixerModel(SceneEditor editor) {
        this.editor = editor;
    }

    SceneEditor editor() {
        return editor;
    }

    /** Returns the relative mode: true keeps the ratios of several selected strips, false sets them to the same value. */
    BooleanProperty relativeProperty() {
        return relative;
    }

    ReadOnlyObjectProperty<Set<MixerChannel>> selectedProperty() {
        return selected.getReadOnlyProperty();
    }

    boolean isSelected(MixerChannel channel) {
        return selected.get().contains(channel);
    }

    /** Selects one channel only; a light also becomes the editor's selection. */
    void select(MixerChannel channel) {
        anchor = channel;
        setSelected(List.of(channel));
    }

    /** Adds a channel to the selection, or removes it. */
    void toggle(MixerChannel channel) {
        Set<MixerChannel> channels = new LinkedHashSet<>(selected.get());
        if (!channels.remove(channel)) {
            channels.add(channel);
        }
        anchor = channel;
        setSelected(channels);
    }

    /** Selects the range from the last selected channel to this one. */
    void selectRange(MixerChannel channel, List<MixerChannel> shown) {
        int from = Math.max(0, shown.indexOf(anchor));
        int to = shown.indexOf(channel);
        setSelected(shown.subList(Math.min(from, to), Math.max(from, to) + 1));
    }

    /** Returns the environment's light gain before it was muted. */
    double environmentGain() {
        return environmentGain;
    }

    /** Remembers the light gain to which the environment returns after it is muted. */
    void setEnvironmentGain(double gain) {
        environmentGain = gain;
    }

    /** Replaces the selection. */
    void setSelected(Iterable<MixerChannel> channels) {
        Set<MixerChannel> newSelection = new LinkedHashSet<>();
        channels.forEach(newSelection::add);
        selected.set(newSelection);
        if (newSelection.size() == 1) {
            newSelection.iterator().next().lightName().ifPresent(editor.selection()::selectLight);
        }
    }

    /** Follows the editor's light selection, unless several strips are selected. */
    void followSelection(Light light) {
        if (selected.get().size() <= 1) {
            selected.set(Set.of(MixerChannel.ofLight(light.name())));
        }
    }

    /**
     * Returns the channels that an edit of a strip changes: the whole selection if it contains the strip. Otherwise selects the strip
     * alone.
     */
    private Set<MixerChannel> editedChannels(MixerChannel channel) {
        if (!isSelected(channel)) {
            select(channel);
        }
        return selected.get();
    }

    /** Starts a drag of a strip: relative edits refer to the current scene. */
    void beginDrag(MixerChannel channel) {
        editedChannels(channel);
        sceneBeforeDrag = editor.scene();
    }

    /** Starts a drag of the master; see {@link #beginDrag(MixerChannel)}. */
    void beginDrag() {
        sceneBeforeDrag = editor.scene();
    }

    void endDrag() {
        sceneBeforeDrag = null;
    }

    private Scene baseScene() {
        return sceneBeforeDrag == null ? editor.scene() : sceneBeforeDrag;
    }

    /** Sets the intensity of a strip and of those selected with it, relative or absolute. */
    Optional<String> setIntensity(MixerChannel channel, double intensity, @Nullable Object gesture) {
        Set<MixerChannel> channels = editedChannels(channel);
        Scene startScene = baseScene();
        double oldIntensity = channel.values(startScene).intensity();
        if (!relative.get() || channels.size() == 1) {
            return edit(scene -> MixerEdits.setIntensity(scene, channels, intensity), gesture);
        }
        if (oldIntensity == 0) {
            return report(
                    Optional.of(Messages.tr("{0} is at 0, so it cannot be scaled. Choose Absolute, or drag another strip",
                            channel.title(startScene))));
        }
        return edit(scene -> MixerEdits.scaleIntensity(scene, startScene, channels, intensity / oldIntensity), gesture);
    }

    /** Makes all lights and the environment brighter by a number of stops. */
    Optional<String> setMaster(double stops, @Nullable Object gesture) {
        Scene startScene = baseScene();
        return edit(scene -> MixerEdits.scaleAll(scene, startScene, Math.pow(2, stops)), gesture);
    }

    /** Edits a strip and those selected with it. */
    Optional<String> editSelected(MixerChannel channel, BiFunction<Scene, MixerChannel, Scene> edit, @Nullable Object gesture) {
        Set<MixerChannel> channels = editedChannels(channel);
        return edit(scene -> MixerEdits.editEach(scene, channels, edit), gesture);
    }

    /** Applies an edit and renders it immediately. */
    Optional<String> edit(Function<Scene, EditOutcome> edit, @Nullable Object gesture) {
        return editor.editAndRenderOrReport(edit, gesture);
    }

    /** Shows why an input is invalid; does nothing for an empty reason. */
    void reportRefusal(String refusal) {
        report(Optional.of(refusal).filter(reason -> !reason.isEmpty()));
    }

    private Optional<String> report(Optional<String> refusal) {
        refusal.ifPresent(editor.message()::show);
        return refusal;
    }
}
