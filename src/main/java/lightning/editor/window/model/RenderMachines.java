package lightning.editor.window.model;

import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;

/** Render nodes entered by the user. */
public final class RenderMachines {
    private final StringProperty hosts = new SimpleStringProperty("");
    private final StringProperty certificate = new SimpleStringProperty("");

    /** Addresses of the nodes, for example {@code render7:7800, render8}. */
    public StringProperty hostsProperty() {
        return hosts;
    }

    /** File of the certificate shared by all nodes. */
    public StringProperty certificateProperty() {
        return certificate;
    }

    /** Reads the machines from the preferences. */
    public void restore(Preferences preferences) {
        hosts.set(preferences.text("machines", ""));
        certificate.set(preferences.text("certificate", ""));
    }

    /** Stores the machines in the preferences. */
    public void save(Preferences preferences) {
        preferences.set("machines", hosts.get());
        preferences.set("certificate", certificate.get());
    }
}
