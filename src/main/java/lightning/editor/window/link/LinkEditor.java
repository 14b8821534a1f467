package lightning.editor.window.link;

import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.LinkEdits;
import lightning.document.LinkTable;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Edits of links, as the mouse and the keyboard make them. */
final class LinkEditor {
    private final SceneEditor editor;
    private final Set<String> closedGroups;
    private final Runnable refresh;
    private final StringProperty status = new SimpleStringProperty("");

    /**
     * @param closedGroups names of closed groups, changed by {@link #toggleGroup}
     * @param refresh      called after a group was opened or closed
     */
    LinkEditor(SceneEditor editor, Set<String> closedGroups, Runnable refresh) {
        this.editor = editor;
        this.closedGroups = closedGroups;
        this.refresh = refresh;
    }

    /** Describes the link under the pointer, or that of the keyboard. */
    StringProperty statusProperty() {
        return status;
    }

    void describe(Light light, LinkTable.Row row) {
        status.set(Messages.tr("{0} on {1}: {2}", light.name(), row.name(), LinkTable.link(light, row).describe()));
    }

    /** Links an object that is not linked completely, or unlinks it. */
    void toggle(Light light, LinkTable.Row row) {
        boolean linked = LinkTable.link(light, row).state() != LinkTable.State.ON;
        edit(scene -> LinkEdits.link(scene, light.name(), LightAttribute.ILLUMINATES, row.name(), linked), null);
    }

    /**
     * Sets a gain, limited to the valid range.
     *
     * @param gesture identifies a drag; null for a separate undo step
     * @param keep    as in {@link LinkEdits#setGain}
     */
    void setGain(Light light, LinkTable.Row row, double gain, @Nullable Object gesture, boolean keep) {
        double valid = Math.clamp(gain, 0, SceneLimits.MAX_GAIN);
        edit(scene -> LinkEdits.setGain(scene, light.name(), row.name(), valid, keep), gesture);
    }

    void resetGain(Light light, LinkTable.Row row) {
        edit(scene -> LinkEdits.resetGain(scene, light.name(), row.name()), null);
    }

    private void edit(Function<Scene, EditOutcome> change, @Nullable Object gesture) {
        editor.editOrReport(change, gesture);
    }

    void toggleGroup(LinkTable.Row row) {
        if (!closedGroups.remove(row.name())) {
            closedGroups.add(row.name());
        }
        refresh.run();
    }

    void selectLight(Light light) {
        editor.selection().selectLight(light.name());
    }

    void selectObject(LinkTable.Row row) {
        editor.selection().selectNode(row.name());
    }

    /** Parses a gain in percent: {@code 30}, {@code 30 %}; the consumer is not called for other text. */
    static void parsePercent(String text, Consumer<Double> gain) {
        String number = text.replace("%", "").replace(',', '.').strip();
        try {
            double percent = Double.parseDouble(number);
            if (Double.isFinite(percent)) {
                gain.accept(percent / 100);
            }
        } catch (NumberFormatException e) {
            // The gain stays as it is.
        }
    }
}
