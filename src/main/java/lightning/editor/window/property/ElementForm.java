package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.layout.VBox;
import lightning.editor.EditorState;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ValueWidget;
import lightning.scene.SceneElement;
import lightning.scene.attribute.PlacementAttribute;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/**
 * Form over the attributes of one element of the scene: its rows, what they show, and when. Subclasses describe the element and arrange the
 * rows, which {@link AttributeForm} creates.
 *
 * @param <T> type of the element's record
 */
abstract class ElementForm<T> extends VBox {
    final EditorModel model;
    final SceneEditor editor;
    private final @Nullable PropertyMenu menu;
    private final List<Row<T, ?>> rows = new ArrayList<>();
    private final List<Part<T>> parts = new ArrayList<>();
    private Object shownElement = Optional.empty();

    /** Widget of an attribute. */
    private record Row<T, V>(SceneAttribute<T, ?> attribute, ValueWidget<V> widget, Function<T, V> value) {}

    /** Nodes that are shown only while a record meets a condition. */
    private record Part<T>(Predicate<T> condition, List<? extends Node> nodes) {
        void show(T record) {
            boolean isShown = condition.test(record);
            nodes.forEach(node -> SectionLayout.setShown(node, isShown));
        }
    }

    /** @param menu  context menu of the properties; null for none */
    ElementForm(EditorModel model, @Nullable PropertyMenu menu) {
        this.model = model;
        this.menu = menu;
        editor = model.editor();
    }

    /** Returns the element that is shown and edited; empty for none. */
    abstract Optional<SceneElement<T>> selected();

    /** Returns why the widgets are disabled without an element, as a clause. */
    abstract String missingReason();

    /** Returns why an attribute has no effect, as a clause; empty if it has. */
    Optional<String> inactiveReason(SceneAttribute<T, ?> attribute, T record) {
        return attribute.inactiveReason(record);
    }

    /** Returns whether the rows of an attribute are shown. */
    boolean isShown(SceneAttribute<T, ?> attribute, T record) {
        return true;
    }

    /** Returns what uncommitted input belongs to: it is discarded when another one is selected. */
    Object owner() {
        return List.of(editor.document(), selected());
    }

    final Optional<T> record() {
        return selected().flatMap(element -> element.find(editor.scene()));
    }

    /** Shows the selected element now, and whenever a state may have changed it. Discards uncommitted input of another even while hidden. */
    final void showWhile(ObservableValue<EditorState> visibleState) {
        editor.editorStateProperty().subscribe(_ -> discardInput());
        visibleState.subscribe(_ -> show());
    }

    /** Discards uncommitted input if another element is selected. */
    final void discardInput() {
        Object owner = owner();
        if (!owner.equals(shownElement)) {
            shownElement = owner;
            revert();
        }
    }

    /** Discards uncommitted input. */
    void revert() {
        rows.forEach(row -> row.widget().revert());
    }

    /** Shows the selected element. */
    void show() {
        Optional<T> record = record();
        record.ifPresent(r -> parts.forEach(part -> part.show(r)));
        rows.forEach(row -> show(row, record));
    }

    private <V> void show(Row<T, V> row, Optional<T> record) {
        row.widget().setDisabledReason(record.isEmpty() ? Optional.of(missingReason()) : inactiveReason(row.attribute(), record.get()));
        record.map(row.value()).ifPresentOrElse(row.widget()::show, row.widget()::showNothing);
    }

    /** Adds the widget of an attribute to those that are updated. */
    final <V, W extends Node & ValueWidget<V>> W add(SceneAttribute<T, ?> attribute, W widget, Function<T, V> value) {
        var row = new Row<>(attribute, widget, value);
        rows.add(row);
        show(row, record());
        attachMenu(widget, attribute);
        return widget;
    }

    /** Attaches the context menu of an attribute. The menu of a texture contains its placement. */
    final void attachMenu(Node node, SceneAttribute<T, ?> attribute) {
        if (menu != null && !(attribute instanceof PlacementAttribute)) {
            menu.attach(node, new SelectedProperty<>(this::selected, attribute));
        }
    }

    /** Shows nodes only while the element meets a condition. Returns the nodes. */
    final <N extends Node> List<N> onlyIf(Predicate<T> condition, List<N> nodes) {
        var part = new Part<>(condition, nodes);
        parts.add(part);
        record().ifPresent(part::show);
        return nodes;
    }

    /** Returns a column of rows that is shown only while the element meets a condition. */
    @SafeVarargs
    final List<Node> columnIf(Predicate<T> condition, List<? extends Node>... rows) {
        return onlyIf(condition, List.of(SectionLayout.column(rows)));
    }
}
