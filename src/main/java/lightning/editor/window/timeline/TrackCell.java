package lightning.editor.window.timeline;

import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.layout.HBox;
import lightning.base.text.Texts;

/** A line of the timeline: a name, and keys beside it. */
final class TrackCell extends ListCell<Row> {
    /** Of names, pixels. */
    static final double NAME = 150;
    static final double HEIGHT = 20;

    private final Timeline timeline;
    private final Label name = new Label();
    private final Lane lane = new Lane();

    TrackCell(Timeline timeline) {
        this.timeline = timeline;
        name.setMinWidth(NAME);
        name.setMaxWidth(NAME);
        name.setPrefHeight(HEIGHT);
        name.getStyleClass().add("track-name");
        var row = new HBox(name, lane);
        row.setPrefHeight(HEIGHT);
        HBox.setHgrow(lane, javafx.scene.layout.Priority.ALWAYS);
        setGraphic(row);
        setPrefWidth(0);
        setPrefHeight(HEIGHT);
        timeline.scaleProperty().subscribe(_ -> draw());
        timeline.keyChoice().keysProperty().subscribe(_ -> draw());
    }

    @Override
    protected void updateItem(Row row, boolean empty) {
        super.updateItem(row, empty);
        getGraphic().setVisible(!empty);
        getStyleClass().removeAll("thing");
        if (!empty) {
            name.setText(switch (row) {
                case Row.OfThing t -> Names.of(t.target());
                case Row.OfTrack t -> Names.attribute(t.track());
            });
            name.setAccessibleText(Texts.of("keys of {0}", name.getText()));
            if (row instanceof Row.OfThing) {
                getStyleClass().add("thing");
            }
            draw();
        }
    }

    private void draw() {
        if (!isEmpty() && getItem() != null && timeline != null) {
            lane.show(getItem(), timeline.scaleProperty().get(), timeline.keyChoice().keys(), HEIGHT);
        }
    }
}
