/** JSON objects of the command line and the server, in the form of docs/json.md. */
package lightning.format.json;
