package lightning.editor.window.command;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.text.TextAlignment;
import lightning.base.text.Messages;
import lightning.editor.window.widget.PixelImage;
import lightning.format.exchange.LightUnits;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** A button for each thing that the numbers of a file's lights may be, with the picture that it makes. */
final class LightUnitChooser extends VBox {
    private static final double GAP = 12;

    private Optional<LightUnits> chosen = Optional.empty();

    /**
     * @param maxWidth in pixels of the screen's own scale: pictures become smaller where all of them would be wider
     * @param onChosen   runs when one was chosen
     */
    LightUnitChooser(Map<LightUnits, Film> pictures, double maxWidth, Runnable onChosen) {
        super(GAP);
        var explanation =
                new Label(
                        Messages.tr("The file does not state the unit of its light intensities. These previews leave out textures."));
        explanation.setWrapText(true);
        var cards = new HBox(GAP);
        pictures.forEach((units, film) -> {
            var picture = new ImageView(image(film));
            picture.setPreserveRatio(true);
            // Half a gap and more lies between a card's edge and its picture.
            picture.setFitWidth(Math.min(film.width(), (maxWidth - GAP) / pictures.size() - 3 * GAP));
            var card = new Button(title(units), picture);
            card.setPrefWidth(picture.getFitWidth() + 2 * GAP);
            card.setWrapText(true);
            card.setTextAlignment(TextAlignment.CENTER);
            card.setId("units-" + units.name().toLowerCase(Locale.ROOT));
            card.setContentDisplay(ContentDisplay.TOP);
            card.setAccessibleText(Messages.tr("Read intensities as {0}", units.description()));
            card.setOnAction(_ -> {
                chosen = Optional.of(units);
                onChosen.run();
            });
            cards.getChildren().add(card);
        });
        // The line is as wide as the pictures.
        explanation.prefWidthProperty().bind(cards.widthProperty());
        explanation.setMaxWidth(USE_PREF_SIZE);
        getChildren().setAll(explanation, cards);
    }

    /** What was chosen; empty where nothing was. */
    Optional<LightUnits> chosen() {
        return chosen;
    }

    private static String title(LightUnits units) {
        return switch (units) {
            case CANDELA -> Messages.tr("Candela and lux (per the format)");
            case UNITLESS -> Messages.tr("Watts per steradian (unitless)");
            case WATTS -> Messages.tr("Watts");
        };
    }

    private static Image image(Film film) {
        return PixelImage.of(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
    }
}
