package lightning.review;

import java.util.List;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Texts of pages. A page has them in all languages, since its reader may have another one than its writer. */
final class PageTexts {
    /** English texts of the script and of the markup, in which {@code {0}}, {@code {1}} … are placeholders. */
    static final List<String> ALL = List.of(
            Messages.key("This look differs in more than faders can show, so it is a fixed picture."),
            Messages.key("Add Note in the Middle"),
            Messages.key("All faders are reset."),
            Messages.key("As Sent"),
            Messages.key("Click the picture to pin a note."),
            Messages.key("Color of {0}"),
            Messages.key("Compare with"),
            Messages.key("Comparison"),
            Messages.key("Delete Note"),
            Messages.key("Delete note {0}"),
            Messages.key("Exposure"),
            Messages.key("Frame {0}"),
            Messages.key("Frames of the shot"),
            Messages.key("Left {0}, right {1}"),
            Messages.key("Light group {0}"),
            Messages.key("Light {0}"),
            Messages.key("Lights and notes"),
            Messages.key("Live: your changes move the scene"),
            Messages.key("Live: your changes stay in this page"),
            Messages.key("Move the faders to where they show the look"),
            Messages.key("Mute {0}"),
            Messages.key("Note {0}"),
            Messages.key("Note {0} is deleted."),
            Messages.key("Note {0}, frame {1}"),
            Messages.key("Nothing"),
            Messages.key("Picture"),
            Messages.key("Picture of {0}. {1}. Click to pin a note."),
            Messages.key("Pinned Notes"),
            Messages.key("Reading layer {0} of {1} …"),
            Messages.key("Reset"),
            Messages.key("Save Review"),
            Messages.key("Saved review.json. Send it to the artist."),
            Messages.key("Show"),
            Messages.key("Show frame {0} of note {1}"),
            Messages.key("Show the picture as it was sent"),
            Messages.key("Show the right side on the left, and the left one on the right"),
            Messages.key("Shows {0}"),
            Messages.key("Solo {0}"),
            Messages.key("Swap (X)"),
            Messages.key("Text of note {0}"),
            Messages.key("The change did not arrive: the connection is lost."),
            Messages.key("The connection is lost; trying again …"),
            Messages.key("The faders show {0}."),
            Messages.key("The live review has ended."),
            Messages.key("The picture does not fit into the memory of this device's graphics."),
            Messages.key("This page needs a newer browser, with WebGL 2: Chrome 80, Firefox 113, Safari 16.4 or later."),
            Messages.key("Use This Light"),
            Messages.key("Waiting for the picture …"),
            Messages.key("Wipe"),
            Messages.key("Your Light"),
            Messages.key("Your name"),
            Messages.key("by {0} stops"),
            Messages.key("no light is changed"),
            Messages.key("off"),
            Messages.key("{0} (fixed picture)"),
            Messages.key("{0} is muted"),
            Messages.key("{0} is solo"),
            Messages.key("{0} percent {1}"),
            Messages.key("{0} – review"),
            Messages.key("{0}, frame {1}"));

    private PageTexts() {}

    /** Returns the translations by the letters of their language, each by the English text. */
    static ObjectNode json() {
        ObjectNode languages = JsonNodeFactory.instance.objectNode();
        for (Language language : Language.values()) {
            if (language != Language.ENGLISH) {
                ObjectNode texts = languages.putObject(language.letters());
                ALL.forEach(english -> texts.put(english, Messages.in(language, english)));
            }
        }
        return languages;
    }
}
