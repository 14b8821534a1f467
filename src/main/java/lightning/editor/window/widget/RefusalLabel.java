package lightning.editor.window.widget;

import java.util.List;
import java.util.stream.Collectors;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.scene.control.Label;

/** Label below number fields that shows why their input was refused; takes no space if empty. */
final class RefusalLabel extends Label {
    RefusalLabel(List<NumberField> fields) {
        getStyleClass().add("refusal");
        setWrapText(true);
        textProperty().bind(Bindings.createStringBinding(
                () -> fields.stream().map(f -> f.refusalProperty().get()).filter(s -> !s.isEmpty())
                        .collect(Collectors.joining("; ")),
                fields.stream().map(NumberField::refusalProperty).toArray(Observable[]::new)));
        visibleProperty().bind(textProperty().isNotEmpty());
        managedProperty().bind(visibleProperty());
    }
}
